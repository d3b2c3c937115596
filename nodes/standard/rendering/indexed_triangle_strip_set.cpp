#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/indexed_triangle_strip_set.h>

namespace pleura {

void IndexedTriangleStripSet::declare(NodeType& type) {
  X3DComposedGeometryNode::declare(type);
  type.named("IndexedTriangleStripSet", "Rendering", 3)
      .containedIn("geometry")
      .means("strips of triangles, each sharing an edge with the one before");
  using enum Access;
  type.field<&IndexedTriangleStripSet::index>("index", initializeOnly, {})
      .atLeast(-1)
      .means("numbers of the points of each strip, -1 after each");
  type.field<&IndexedTriangleStripSet::set_index>("set_index", inputOnly, {}).atLeast(-1).means("sets index");
}

void IndexedTriangleStripSet::onInitialize() { set_index.routeNoEvent(index, id); }

bool IndexedTriangleStripSet::topologyChanged() {
  return topology_.changed(index, normalPerVertex, colorPerVertex, ccw, solid);
}

void IndexedTriangleStripSet::collect(std::size_t, FaceList& faces) {
  const auto& points = index.getValue();
  std::size_t first = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i] < 0) first = i + 1;
    if (i < first + 2) continue;
    const bool isOdd = (i - first) % 2 != 0;
    const std::size_t face = faces.size();
    faces.addTriangle(corner(points[isOdd ? i - 1 : i - 2], face),
                      corner(points[isOdd ? i - 2 : i - 1], face), corner(points[i], face));
  }
}

}  // namespace pleura
