#include <fstream>
#include <memory>

#include <fmt/format.h>

#include <pleura/nodes/core/plugin.h>
#include <pleura/nodes/standard/register.h>
#include <pleura/x3d/browser/anatomy/thorax_files.h>
#include <pleura/x3d/browser/commands/commands.h>
#include <pleura/x3d/browser/commands/progress.h>
#include <pleura/x3d/encoding/source_text.h>

namespace pleura {

namespace {

struct Options {
  std::filesystem::path output;
  std::filesystem::path from;
};

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (!out.flush()) throw FileError(path.string() + ": can't be written");
}

void makeAnatomy(const Options& options) {
  NodeRegistry registry;
  registerStandardNodes(registry);
  PluginLoader().load("thorax", registry);
  const bool isReal = !options.from.empty();
  if (isReal && !std::filesystem::is_directory(options.from))
    throw FileError(options.from.string() + ": no such folder");
  std::filesystem::create_directories(options.output);
  if (isReal) throw UsageError("--from is not there yet");
  const Anatomy anatomy = generateAnatomy();
  const std::string source =
      isReal ? "meshes of " + options.from.filename().string()
             : "measured on BodyParts3D, (c) The Database Center for Life Science, CC BY 4.0";
  const auto files = thoraxFiles(anatomy, registry, source);
  for (const auto& file : files) write(options.output / file.name, file.text);
  fmt::print("{} files in {}\n", files.size(), options.output.string());
}

}  // namespace

void addAnatomyCommand(CLI::App& app) {
  auto* command = app.add_subcommand("anatomy", "Write the thorax as scene files: generated, or from meshes");
  const auto options = std::make_shared<Options>();
  command->add_option("-o,--output", options->output, "Folder for the files")->required();
  command->add_option("--from", options->from, "Folder of meshes with skeleton/ and organs/");
  command->callback([options] { makeAnatomy(*options); });
}

}  // namespace pleura
