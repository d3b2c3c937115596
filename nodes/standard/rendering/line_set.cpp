#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/line_set.h>

namespace pleura {

void LineSet::declare(NodeType& type) {
  CoordinateGeometryNode::declare(type);
  type.named("LineSet", "Rendering", 1).containedIn("geometry").means("polylines");
  using enum Access;
  type.field<&LineSet::normal>("normal", inputOutput, {}).means("normals; none: computed");
  type.field<&LineSet::vertexCount>("vertexCount", inputOutput, {})
      .atLeast(2)
      .means("number of points of each line");
}

bool LineSet::topologyChanged() { return topology_.changed(vertexCount); }

void LineSet::collect(std::size_t pointCount, FaceList& faces) {
  std::int32_t point = 0;
  for (const std::int32_t count : vertexCount.getValue()) {
    // One point beyond the last is enough for the line to be left out.
    for (std::int32_t i = 0; i < count && static_cast<std::size_t>(point) <= pointCount; ++i, ++point)
      faces.add({point, -1, point});
    faces.endFace();
  }
}

std::vector<std::uint32_t> LineSet::primitives(const FaceList& faces, std::span<const Vec3f>) {
  return faces.segments();
}

void LineSet::setProperties(RenderMesh& mesh) { mesh.primitive = RenderMesh::Primitive::lines; }

}  // namespace pleura
