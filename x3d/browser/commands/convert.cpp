#include <algorithm>
#include <fstream>
#include <memory>

#include <fmt/format.h>

#include <pleura/nodes/built_in_nodes.h>
#include <pleura/nodes/deformable/mesh/refinement.h>
#include <pleura/nodes/deformable/mesh/repair.h>
#include <pleura/x3d/browser/anatomy/node_maker.h>
#include <pleura/x3d/browser/commands/commands.h>
#include <pleura/x3d/browser/commands/number_in.h>
#include <pleura/x3d/browser/scene/scene.h>
#include <pleura/x3d/encoding/writer.h>
#include <pleura/x3d/import/mesh_import.h>

namespace pleura {

namespace {

struct ConvertOptions {
  std::filesystem::path input;
  std::filesystem::path output;
  double decimate = 1;
  bool repair = false;
  int fillHoles = 0;
  double scale = 1;
  std::string frame;
};

void write(const std::filesystem::path& path, Document& document) {
  std::ofstream out(path, std::ios::binary);
  out << writeX3d(document);
  if (!out.flush()) throw FileError(path.string() + ": can't be written");
}

void convertScene(const ConvertOptions& options) {
  if (options.decimate != 1 || options.fillHoles > 0 || options.repair || options.scale != 1 ||
      !options.frame.empty())
    throw UsageError("--decimate, --fill-holes, --repair, --scale and --frame are for meshes, not for X3D");
  Scene scene;
  scene.load(options.input);
  for (const auto& each : scene.diagnostics().all()) fmt::print(stderr, "{}\n", toText(each));
  if (scene.diagnostics().errors() > 0) throw Fault(options.input.string() + ": not converted");
  write(options.output, scene.document());
}

TriangleMesh prepared(TriangleMesh mesh, const std::string& name, const ConvertOptions& options) {
  if (options.repair || options.fillHoles > 0) {
    const auto report = repair(mesh, {.maxHoleEdges = options.fillHoles});
    for (const auto& line : deeds(report)) fmt::print(stderr, "{}: {}\n", name, line);
  }
  if (options.decimate < 1)
    mesh = decimate(mesh, static_cast<int>(options.decimate * static_cast<double>(mesh.triangles.size())));
  return mesh;
}

NodePtr shapeOf(const NodeMaker& maker, const ImportedPart& part, const TriangleMesh& mesh) {
  const auto material = maker.make("Material");
  maker.set<SFColor>(material, "diffuseColor", part.colour.head<3>());
  maker.set<SFFloat>(material, "transparency", 1 - part.colour.w());
  const auto appearance = maker.make("Appearance");
  maker.put(appearance, "material", material);
  std::vector<std::int32_t> index;
  for (const auto& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) index.push_back(triangle[k]);
  const auto coordinate = maker.make("Coordinate");
  maker.set<MFVec3f>(coordinate, "point", mesh.points);
  const auto geometry = maker.make("IndexedTriangleSet");
  maker.set<MFInt32>(geometry, "index", index);
  maker.set<SFBool>(geometry, "solid", false);
  maker.put(geometry, "coord", coordinate);
  auto shape = maker.make("Shape");
  maker.put(shape, "appearance", appearance);
  maker.put(shape, "geometry", geometry);
  return shape;
}

void convertMesh(const ConvertOptions& options) {
  MeshImportOptions import{options.scale};
  if (!options.frame.empty()) import.axes = axesNamed(options.frame);
  const auto imported = importMesh(options.input, import);
  for (const auto& line : imported.diagnostics)
    fmt::print(stderr, "{}: warning: {}\n", options.input.string(), line);
  NodeRegistry registry;
  registerBuiltInNodes(registry);
  const NodeMaker maker(registry);
  Document document;
  document.meta = {{"title", options.output.filename().string()},
                   {"source", options.input.filename().string()}};
  for (const auto& part : imported.parts)
    document.nodes.push_back(shapeOf(maker, part, prepared(part.mesh, part.name, options)));
  write(options.output, document);
}

void convert(const ConvertOptions& options) {
  const auto ending = options.input.extension();
  ending == ".x3d" || ending == ".x3dz" ? convertScene(options) : convertMesh(options);
}

}  // namespace

void addConvertCommand(CLI::App& app) {
  auto* command = app.add_subcommand("convert", "X3D, or any mesh assimp reads, to X3D");
  const auto options = std::make_shared<ConvertOptions>();
  command->add_option("IN", options->input, "X3D, OBJ, STL, PLY, glTF, ...")->required();
  command->add_option("-o,--output", options->output, "X3D file")->required();
  command->add_option("--decimate", options->decimate, "Share of the triangles that is kept")
      ->check(numberIn(0, 1));
  command->add_flag("--repair", options->repair, "Weld, orient, drop what is broken");
  command
      ->add_option("--fill-holes", options->fillHoles, "Close holes of up to so many edges (repairs first)")
      ->check(CLI::Range(0, 100000));
  command->add_option("--scale", options->scale, "Metres in the file's unit of length")
      ->check(numberIn(1e-9, 1e9));
  command->add_option("--frame", options->frame, "The file's axes that are X3D's x, y and z, as \"x z -y\"");
  command->callback([options] { convert(*options); });
}

}  // namespace pleura
