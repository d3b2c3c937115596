#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/indexed_triangle_set.h>

namespace pleura {

void IndexedTriangleSet::declare(NodeType& type) {
  X3DComposedGeometryNode::declare(type);
  type.named("IndexedTriangleSet", "Rendering", 3)
      .containedIn("geometry")
      .means("triangles that share points");
  using enum Access;
  type.field<&IndexedTriangleSet::index>("index", initializeOnly, {})
      .atLeast(0)
      .means("numbers of the points, three a triangle");
  type.field<&IndexedTriangleSet::set_index>("set_index", inputOnly, {}).atLeast(0).means("sets index");
}

void IndexedTriangleSet::onInitialize() { set_index.routeNoEvent(index, id); }

bool IndexedTriangleSet::topologyChanged() {
  return topology_.changed(index, normalPerVertex, colorPerVertex, ccw, solid);
}

void IndexedTriangleSet::collect(std::size_t, FaceList& faces) {
  const auto& points = index.getValue();
  for (std::size_t i = 0; i + 2 < points.size(); i += 3)
    faces.addTriangle(corner(points[i], i / 3), corner(points[i + 1], i / 3), corner(points[i + 2], i / 3));
}

}  // namespace pleura
