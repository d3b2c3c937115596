#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/indexed_line_set.h>

namespace pleura {

void IndexedLineSet::declare(NodeType& type) {
  CoordinateGeometryNode::declare(type);
  type.named("IndexedLineSet", "Rendering", 1).containedIn("geometry").means("polylines that share points");
  using enum Access;
  type.field<&IndexedLineSet::colorIndex>("colorIndex", initializeOnly, {})
      .atLeast(-1)
      .means("which colour for each corner or line; empty: as coordIndex");
  type.field<&IndexedLineSet::colorPerVertex>("colorPerVertex", initializeOnly, true)
      .means("whether a colour belongs to a vertex, or to a line");
  type.field<&IndexedLineSet::coordIndex>("coordIndex", initializeOnly, {})
      .atLeast(-1)
      .means("numbers of the points of each line, -1 after each");
  type.field<&IndexedLineSet::normal>("normal", inputOutput, {}).means("normals; none: computed");
  type.field<&IndexedLineSet::set_colorIndex>("set_colorIndex", inputOnly, {})
      .atLeast(-1)
      .means("sets colorIndex");
  type.field<&IndexedLineSet::set_coordIndex>("set_coordIndex", inputOnly, {})
      .atLeast(-1)
      .means("sets coordIndex");
}

void IndexedLineSet::onInitialize() {
  set_colorIndex.routeNoEvent(colorIndex, id);
  set_coordIndex.routeNoEvent(coordIndex, id);
}

bool IndexedLineSet::topologyChanged() { return topology_.changed(coordIndex, colorIndex, colorPerVertex); }

void IndexedLineSet::collect(std::size_t, FaceList& faces) {
  const auto& points = coordIndex.getValue();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i] < 0) {
      faces.endFace();
      continue;
    }
    faces.add(
        {points[i], -1,
         attributeNumber(colorIndex.getValue(), colorPerVertex.getValue(), i, faces.size(), points[i])});
  }
  faces.endFace();
}

std::vector<std::uint32_t> IndexedLineSet::primitives(const FaceList& faces, std::span<const Vec3f>) {
  return faces.segments();
}

void IndexedLineSet::setProperties(RenderMesh& mesh) { mesh.primitive = RenderMesh::Primitive::lines; }

}  // namespace pleura
