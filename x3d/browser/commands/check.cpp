#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <pleura/x3d/browser/commands/commands.h>
#include <pleura/x3d/browser/scene/scene.h>

namespace pleura {

namespace {

struct CheckOptions {
  std::vector<std::filesystem::path> files;
  bool strict = false;
  bool json = false;
  bool allowOutside = false;
};

void check(const CheckOptions& options) {
  std::size_t errors = 0;
  std::size_t warnings = 0;
  for (const auto& file : options.files) {
    Scene scene;
    ReaderLimits limits;
    limits.outsideFolder = options.allowOutside;
    scene.load(file, limits);
    const auto& found = scene.diagnostics();
    for (const auto& each : found.all()) fmt::print("{}\n", options.json ? toJson(each) : toText(each));
    if (found.unlisted() > 0 && !options.json)
      fmt::print("{}: and {} more\n", file.string(), found.unlisted());
    errors += found.errors();
    warnings += found.warnings();
  }
  if (!options.json)
    fmt::print("{} file{}: {} errors, {} warnings\n", options.files.size(),
               options.files.size() == 1 ? "" : "s", errors, warnings);
  if (errors > 0 || (options.strict && warnings > 0)) throw Fault("");
}

}  // namespace

void addCheckCommand(CLI::App& app) {
  auto* command = app.add_subcommand("check", "Tell every fault of scene files, with file:line:column");
  const auto options = std::make_shared<CheckOptions>();
  command->add_option("FILES", options->files, "X3D files")->required();
  command->add_flag("--strict", options->strict, "Warnings are faults too");
  command->add_flag("--json", options->json, "A line of JSON for each");
  command->add_flag("--allow-outside", options->allowOutside, "Let Inlines read outside the scene's folder");
  command->callback([options] { check(*options); });
}

}  // namespace pleura
