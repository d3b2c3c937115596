#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/triangle_set.h>

namespace pleura {

void TriangleSet::declare(NodeType& type) {
  X3DComposedGeometryNode::declare(type);
  type.named("TriangleSet", "Rendering", 3).containedIn("geometry").means("triangles, three points each");
}

bool TriangleSet::topologyChanged() { return topology_.changed(normalPerVertex, colorPerVertex, ccw, solid); }

void TriangleSet::collect(std::size_t pointCount, FaceList& faces) {
  const auto count = static_cast<std::int32_t>(pointCount);
  for (std::int32_t i = 0; i + 2 < count; i += 3) {
    const std::size_t face = faces.size();
    faces.addTriangle(corner(i, face), corner(i + 1, face), corner(i + 2, face));
  }
}

}  // namespace pleura
