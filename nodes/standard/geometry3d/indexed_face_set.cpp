#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/geometry3d/indexed_face_set.h>

namespace pleura {

void IndexedFaceSet::declare(NodeType& type) {
  X3DComposedGeometryNode::declare(type);
  type.named("IndexedFaceSet", "Geometry3D", 2).containedIn("geometry").means("polygons that share points");
  using enum Access;
  type.field<&IndexedFaceSet::colorIndex>("colorIndex", initializeOnly, {})
      .atLeast(-1)
      .means("which colour for each corner or face; empty: as coordIndex");
  type.field<&IndexedFaceSet::convex>("convex", initializeOnly, true).means("whether every face is convex");
  type.field<&IndexedFaceSet::coordIndex>("coordIndex", initializeOnly, {})
      .atLeast(-1)
      .means("numbers of the points of each face, -1 after each");
  type.field<&IndexedFaceSet::creaseAngle>("creaseAngle", initializeOnly, 0)
      .measuredIn(Unit::angle)
      .atLeast(0)
      .means("faces that meet at less are shaded as one smooth surface");
  type.field<&IndexedFaceSet::normalIndex>("normalIndex", initializeOnly, {})
      .atLeast(-1)
      .means("which normal for each corner or face; empty: as coordIndex");
  type.field<&IndexedFaceSet::texCoordIndex>("texCoordIndex", initializeOnly, {})
      .atLeast(-1)
      .means("which texture point for each corner; empty: as coordIndex");
  type.field<&IndexedFaceSet::set_colorIndex>("set_colorIndex", inputOnly, {})
      .atLeast(-1)
      .means("sets colorIndex");
  type.field<&IndexedFaceSet::set_coordIndex>("set_coordIndex", inputOnly, {})
      .atLeast(-1)
      .means("sets coordIndex");
  type.field<&IndexedFaceSet::set_normalIndex>("set_normalIndex", inputOnly, {})
      .atLeast(-1)
      .means("sets normalIndex");
  type.field<&IndexedFaceSet::set_texCoordIndex>("set_texCoordIndex", inputOnly, {})
      .atLeast(-1)
      .means("sets texCoordIndex");
}

void IndexedFaceSet::onInitialize() {
  set_colorIndex.routeNoEvent(colorIndex, id);
  set_coordIndex.routeNoEvent(coordIndex, id);
  set_normalIndex.routeNoEvent(normalIndex, id);
  set_texCoordIndex.routeNoEvent(texCoordIndex, id);
}

bool IndexedFaceSet::topologyChanged() {
  return topology_.changed(coordIndex, normalIndex, colorIndex, normalPerVertex, colorPerVertex, creaseAngle,
                           convex, ccw, solid);
}

void IndexedFaceSet::collect(std::size_t, FaceList& faces) {
  const auto& points = coordIndex.getValue();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i] < 0) {
      faces.endFace();
      continue;
    }
    const std::size_t face = faces.size();
    faces.add({points[i],
               attributeNumber(normalIndex.getValue(), normalPerVertex.getValue(), i, face, points[i]),
               attributeNumber(colorIndex.getValue(), colorPerVertex.getValue(), i, face, points[i])});
  }
  faces.endFace();
}

}  // namespace pleura
