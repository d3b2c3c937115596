#include <numbers>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/triangulation.h>
#include <pleura/nodes/standard/rendering/x3d_composed_geometry_node.h>

namespace pleura {

void X3DComposedGeometryNode::declare(NodeType& type) {
  CoordinateGeometryNode::declare(type);
  using enum Access;
  type.field<&X3DComposedGeometryNode::ccw>("ccw", initializeOnly, true)
      .means("whether front faces are counterclockwise");
  type.field<&X3DComposedGeometryNode::colorPerVertex>("colorPerVertex", initializeOnly, true)
      .means("whether a colour belongs to a vertex, or to a face");
  type.field<&X3DComposedGeometryNode::normal>("normal", inputOutput, {}).means("normals; none: computed");
  type.field<&X3DComposedGeometryNode::normalPerVertex>("normalPerVertex", initializeOnly, true)
      .means("whether a normal belongs to a vertex, or to a face");
  type.field<&X3DComposedGeometryNode::solid>("solid", initializeOnly, true)
      .means("whether only front faces are drawn");
  type.field<&X3DComposedGeometryNode::texCoord>("texCoord", inputOutput, {}).means("points of the texture");
}

void X3DComposedGeometryNode::setProperties(RenderMesh& mesh) {
  mesh.primitive = RenderMesh::Primitive::triangles;
  mesh.solid = solid.getValue();
  mesh.ccw = ccw.getValue();
}

std::vector<std::uint32_t> X3DComposedGeometryNode::primitives(const FaceList& faces,
                                                               std::span<const Vec3f> points) {
  return triangulate(faces, points, areFacesConvex());
}

double X3DComposedGeometryNode::smoothAngle() { return normalPerVertex.getValue() ? std::numbers::pi : 0; }

Corner X3DComposedGeometryNode::corner(std::int32_t point, std::size_t face) {
  const auto own = static_cast<std::int32_t>(face);
  return {point, normalPerVertex.getValue() ? point : own, colorPerVertex.getValue() ? point : own};
}

}  // namespace pleura
