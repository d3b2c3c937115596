#include <pleura/x3d/browser/anatomy/scene_file.h>
#include <pleura/x3d/encoding/writer.h>

namespace pleura {

SceneFile sceneFile(Document& document, const std::string& name, const std::string& what,
                    const std::string& source) {
  document.components = {};
  document.meta = {
      {"title", name + ".x3d"}, {"description", what}, {"source", source}, {"generator", "pleura anatomy"}};
  return {name + ".x3d", writeX3d(document)};
}

NodePtr triangleSet(const NodeMaker& maker, const TriangleMesh& mesh, bool isSolid, float perUnit,
                    const std::string& def) {
  std::vector<Vec3f> points;
  for (const auto& p : mesh.points) points.push_back(rounded(p, perUnit));
  std::vector<std::int32_t> index;
  for (const auto& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) index.push_back(triangle[k]);
  const auto coordinate = maker.make("Coordinate", def);
  maker.set<MFVec3f>(coordinate, "point", points);
  auto geometry = maker.make("IndexedTriangleSet");
  maker.set<MFInt32>(geometry, "index", index);
  maker.set<SFBool>(geometry, "solid", isSolid);
  maker.put(geometry, "coord", coordinate);
  return geometry;
}

}  // namespace pleura
