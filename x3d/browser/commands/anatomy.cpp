#include <fstream>
#include <memory>

#include <fmt/format.h>

#include <pleura/nodes/built_in_nodes.h>
#include <pleura/nodes/core/plugin.h>
#include <pleura/nodes/thorax/anatomy/from_meshes.h>
#include <pleura/x3d/browser/anatomy/chain_files.h>
#include <pleura/x3d/browser/anatomy/thorax_files.h>
#include <pleura/x3d/browser/commands/commands.h>
#include <pleura/x3d/browser/commands/progress.h>
#include <pleura/x3d/encoding/source_text.h>
#include <pleura/x3d/import/mesh_import.h>

namespace pleura {

namespace {

struct AnatomyOptions {
  std::filesystem::path output;
  std::filesystem::path from;
  std::string style = "thorax";
};

/// All parts of a mesh file as one.
TriangleMesh meshOfFile(const std::filesystem::path& file) {
  TriangleMesh all;
  for (const auto& part : importMesh(file).parts) {
    const int first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), part.mesh.points.begin(), part.mesh.points.end());
    for (const auto& triangle : part.mesh.triangles) all.triangles.emplace_back(triangle.array() + first);
  }
  return all;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (!out.flush()) throw FileError(path.string() + ": can't be written");
}

Anatomy realAnatomy(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) throw FileError(folder.string() + ": no such folder");
  try {
    return anatomyFromMeshes(folder, meshOfFile);
  } catch (const std::invalid_argument& bad) {
    throw Fault(bad.what());
  }
}

void makeAnatomy(const AnatomyOptions& options) {
  NodeRegistry registry;
  registerBuiltInNodes(registry);
  PluginLoader().load(options.style, registry);
  const bool isReal = !options.from.empty();
  const Anatomy anatomy = isReal ? realAnatomy(options.from) : generateAnatomy();
  std::filesystem::create_directories(options.output);
  const std::string source =
      isReal ? "meshes of " + options.from.filename().string()
             : "measured on BodyParts3D, (c) The Database Center for Life Science, CC BY 4.0";
  const auto files = options.style == "chain" ? chainFiles(anatomy, registry, source)
                                              : thoraxFiles(anatomy, registry, source);
  for (const auto& file : files) write(options.output / file.name, file.text);
  fmt::print("{} files in {}\n", files.size(), options.output.string());
}

}  // namespace

void addAnatomyCommand(CLI::App& app) {
  auto* command = app.add_subcommand("anatomy", "Write the thorax as scene files: generated, or from meshes");
  const auto options = std::make_shared<AnatomyOptions>();
  command->add_option("-o,--output", options->output, "Folder for the files")->required();
  command->add_option("--from", options->from, "Folder of meshes with skeleton/ and organs/");
  command
      ->add_option("--style", options->style,
                   "thorax; or chain, organ files as the thesis' scenes inline them")
      ->check(CLI::IsMember({"thorax", "chain"}))
      ->capture_default_str();
  command->callback([options] { makeAnatomy(*options); });
}

}  // namespace pleura
