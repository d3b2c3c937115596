#include <memory>

#include <pleura/x3d/browser/commands/commands.h>
#include <pleura/x3d/browser/commands/number_in.h>
#include <pleura/x3d/browser/commands/scene_options.h>

namespace pleura {

void addRunCommand(CLI::App& app) {
  struct Options : SceneOptions {
    double seconds = 0;
  };
  auto* command = app.add_subcommand("run", "Run a scene without a picture, on a virtual clock");
  const auto options = std::make_shared<Options>();
  options->addTo(*command);
  options->addPlaybackTo(*command);
  command->add_option("--for", options->seconds, "Seconds of the scene's time")
      ->required()
      ->check(numberIn(0, 1e9));
  command->add_flag(
      "--real-time", options->playback.isRealTime,
      "On the real clock, haptic loops in threads of their own: for a real device, and for --stats");
  command->callback([options] {
    const auto scene = options->load();
    Playback playback(*scene, options->playback);
    playback.runUntil(options->seconds);
    options->report(*scene, playback);
    if (scene->diagnostics().errors() > 0) throw Fault("");
  });
}

}  // namespace pleura
