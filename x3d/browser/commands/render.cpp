#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <pleura/x3d/browser/commands/commands.h>
#include <pleura/x3d/browser/commands/number_in.h>
#include <pleura/x3d/browser/commands/picture_options.h>
#include <pleura/x3d/browser/commands/progress.h>
#include <pleura/x3d/browser/commands/scene_options.h>
#include <pleura/x3d/browser/render/film_writer.h>

namespace pleura {

namespace {

struct RenderOptions : SceneOptions {
  PictureOptions picture;
  std::filesystem::path output;
  double at = 0;
  double seconds = -1;
  double framesPerSecond = 30;
};

/// What has a memory (a flow, what rises or falls) computes nothing while nobody looks: it is looked at for a
/// second before the picture.
void renderStill(const RenderOptions& options, Scene& scene, Playback& playback) {
  constexpr double kLookedAt = 1;  // [s]
  const auto view = options.picture.view(scene);
  playback.runUntil(options.at, [&](Time now) {
    if (now > options.at - kLookedAt) view->view().update();
  });
  render::writePng(view->picture(), options.output);
}

/// Frames to a film or to numbered pictures in a folder; the clock steps with the frames unless --step is
/// finer.
void renderFrames(const RenderOptions& options, Scene& scene, Playback& playback) {
  auto view = options.picture.view(scene);
  const bool isFilm = options.output.extension() == ".mp4";
  std::unique_ptr<render::FilmWriter> film;
  if (isFilm) {
    film = std::make_unique<render::FilmWriter>(options.output, options.picture.width(),
                                                options.picture.height(), options.framesPerSecond);
  } else {
    std::filesystem::create_directories(options.output);
  }
  Progress progress("rendering");
  const auto frames = static_cast<int>(std::floor(options.seconds * options.framesPerSecond + 1e-9));
  for (int frame = 0; frame <= frames; ++frame) {
    playback.runUntil(frame / options.framesPerSecond);
    const auto picture = view->picture();
    isFilm ? film->write(picture)
           : render::writePng(picture, options.output / fmt::format("{:05}.png", frame));
    progress.show(static_cast<double>(frame) / std::max(1, frames));
  }
  if (film) film->close();
}

void renderScene(RenderOptions options, bool hasStep) {
  const bool isStill = options.output.extension() == ".png";
  if (isStill && options.seconds >= 0)
    throw UsageError("--for makes a film or a folder of pictures: -o x.mp4 or a folder");
  if (!isStill && options.seconds < 0) throw UsageError("a film or a folder of pictures takes --for SECONDS");
  if (!isStill && !hasStep) options.playback.step = 1 / options.framesPerSecond;
  const auto scene = options.load();
  Playback playback(*scene, options.playback);
  isStill ? renderStill(options, *scene, playback) : renderFrames(options, *scene, playback);
  options.report(*scene, playback);
  if (scene->diagnostics().errors() > 0) throw Fault("");
}

}  // namespace

void addRenderCommand(CLI::App& app) {
  auto* command =
      app.add_subcommand("render", "Draw a scene off screen: a picture, a film or a folder of frames");
  const auto options = std::make_shared<RenderOptions>();
  options->addTo(*command);
  options->addPlaybackTo(*command);
  options->picture.addTo(*command);
  command->add_option("-o,--output", options->output, "x.png, x.mp4 or a folder")->required();
  auto* at =
      command->add_option("--at", options->at, "Time of the picture in seconds")->check(numberIn(0, 1e9));
  command->add_option("--for", options->seconds, "Seconds to film")->excludes(at)->check(numberIn(0, 1e6));
  command->add_option("--fps", options->framesPerSecond, "Frames a second")
      ->check(numberIn(0.01, 1000))
      ->capture_default_str();
  command->callback([options, command] { renderScene(*options, command->count("--step") > 0); });
}

}  // namespace pleura
