#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/indexed_triangle_fan_set.h>

namespace pleura {

void IndexedTriangleFanSet::declare(NodeType& type) {
  X3DComposedGeometryNode::declare(type);
  type.named("IndexedTriangleFanSet", "Rendering", 3)
      .containedIn("geometry")
      .means("fans of triangles around a common point");
  using enum Access;
  type.field<&IndexedTriangleFanSet::index>("index", initializeOnly, {})
      .atLeast(-1)
      .means("numbers of the points of each fan, -1 after each");
  type.field<&IndexedTriangleFanSet::set_index>("set_index", inputOnly, {}).atLeast(-1).means("sets index");
}

void IndexedTriangleFanSet::onInitialize() { set_index.routeNoEvent(index, id); }

bool IndexedTriangleFanSet::topologyChanged() {
  return topology_.changed(index, normalPerVertex, colorPerVertex, ccw, solid);
}

void IndexedTriangleFanSet::collect(std::size_t, FaceList& faces) {
  const auto& points = index.getValue();
  std::size_t first = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i] < 0) first = i + 1;
    if (i < first + 2) continue;
    const std::size_t face = faces.size();
    faces.addTriangle(corner(points[first], face), corner(points[i - 1], face), corner(points[i], face));
  }
}

}  // namespace pleura
