#include <numeric>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/point_set.h>

namespace pleura {

void PointSet::declare(NodeType& type) {
  CoordinateGeometryNode::declare(type);
  type.named("PointSet", "Rendering", 1).containedIn("geometry").means("points");
  using enum Access;
  type.field<&PointSet::normal>("normal", inputOutput, {}).means("normals; none: computed");
}

void PointSet::collect(std::size_t pointCount, FaceList& faces) {
  for (std::int32_t i = 0; static_cast<std::size_t>(i) < pointCount; ++i) {
    faces.add({i, -1, i});
    faces.endFace();
  }
}

std::vector<std::uint32_t> PointSet::primitives(const FaceList& faces, std::span<const Vec3f>) {
  std::vector<std::uint32_t> all(faces.corners.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

void PointSet::setProperties(RenderMesh& mesh) { mesh.primitive = RenderMesh::Primitive::points; }

}  // namespace pleura
