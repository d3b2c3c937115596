#include <fmt/format.h>

#include <pleura/nodes/deformable/job.h>
#include <pleura/x3d/browser/commands/commands.h>
#include <pleura/x3d/browser/commands/number_in.h>
#include <pleura/x3d/browser/commands/scene_options.h>
#include <pleura/x3d/browser/scene/state_hash.h>

namespace pleura {

void SceneOptions::addTo(CLI::App& command) {
  command.add_option("SCENE", file, "X3D file")->required();
  command.add_option("--anatomy", anatomy, "Folder that stands in for the scene's own anatomy/ folder");
  command.add_flag("--allow-outside", allowOutside, "Let Inlines read outside the scene's folder");
  command.add_option("--set", playback.set, "DEF.field=VALUE before the first tick; repeat for more")
      ->allow_extra_args(false);
  command.add_option("--device", playback.touch.device,
                     "Haptic device in place of the scene's: simulated, phantom, recorded");
  command.add_option("--record", playback.touch.record,
                     "Where the haptic session is recorded, to be played again");
  command.add_option("--stylus", playback.touch.stylus,
                     "Path of the simulated stylus (CSV), or the recording");
  command.add_option("--threads", threads, "Threads that organs are solved in; default: one a core")
      ->check(numberIn(1, 64));
}

void SceneOptions::addPlaybackTo(CLI::App& command) {
  command.add_option("--step", playback.step, "Seconds from one tick to the next")->capture_default_str();
  command.add_option("--watch", playback.watch, "DEF.field to follow in the CSV; repeat for more")
      ->allow_extra_args(false);
  command.add_option("--csv", playback.csv, "Where the watched fields are written, a row a step");
  command.add_option("--keys", playback.keys, "Keys at times, as \"2.0:p 4.0:p\"");
  command.add_flag("--stats", stats, "Print milliseconds, updates and solves per tick as JSON");
  command.add_flag("--hash", hash, "Print a hash of the state at the end");
}

std::unique_ptr<Scene> SceneOptions::load() const {
  if (threads) setThreads(*threads);
  auto scene = std::make_unique<Scene>();
  ReaderLimits limits;
  limits.outsideFolder = allowOutside;
  limits.anatomyFolder = anatomy;
  if (!anatomy.empty() && !std::filesystem::is_directory(anatomy))
    throw UsageError(anatomy.string() + " is no folder");
  scene->load(file, limits);
  tellDiagnostics(*scene);
  if (scene->document().nodes.empty() && scene->diagnostics().errors() > 0)
    throw Fault(file.string() + ": nothing to show");
  return scene;
}

void SceneOptions::tellDiagnostics(const Scene& scene) const {
  const auto& found = scene.diagnostics();
  for (; told_ < found.all().size(); ++told_) fmt::print(stderr, "{}\n", toText(found.all()[told_]));
  if (found.unlisted() > 0) fmt::print(stderr, "and {} more\n", found.unlisted());
}

void SceneOptions::report(Scene& scene, const Playback& done) const {
  tellDiagnostics(scene);
  if (stats) fmt::print("{}\n", done.statistics().toJson(done.touch().statistics()));
  if (hash) fmt::print("{:016x}\n", stateHash(scene));
}

}  // namespace pleura
