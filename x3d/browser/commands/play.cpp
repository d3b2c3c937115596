#include <memory>

#include <pleura/x3d/browser/commands/commands.h>
#include <pleura/x3d/browser/commands/number_in.h>
#include <pleura/x3d/browser/commands/scene_options.h>
#include <pleura/x3d/browser/view/player.h>

namespace pleura {

void addPlayCommand(CLI::App& app) {
  auto* command = app.add_subcommand(
      "play", "A window: orbit, zoom, pan; P pauses and resumes, arrows change rate and depth");
  struct Options : SceneOptions {
    int width = 1280;
    int height = 720;
    double seconds = 0;
  };
  const auto options = std::make_shared<Options>();
  options->addTo(*command);
  command->add_option("--width", options->width, "Of the window in pixels")->check(CLI::Range(64, 8192));
  command->add_option("--height", options->height, "Of the window in pixels")->check(CLI::Range(64, 8192));
  command->add_option("--for", options->seconds, "Close after so many seconds; 0: when the user does")
      ->check(numberIn(0, 1e9));
  command->callback([options] {
    const auto scene = options->load();
    for (const auto& assignment : options->playback.set) scene->set(assignment);
    Player(*scene, options->playback.touch, options->width, options->height,
           options->file.filename().string())
        .run(options->seconds);
  });
}

}  // namespace pleura
