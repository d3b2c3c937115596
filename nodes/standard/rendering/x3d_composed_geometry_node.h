#pragma once

#include <pleura/nodes/standard/rendering/coordinate_geometry_node.h>
#include <pleura/nodes/standard/texturing/x3d_texture_coordinate_node.h>

namespace pleura {

/// Geometry of faces.
class X3DComposedGeometryNode : public CoordinateGeometryNode {
 public:
  SFBool ccw;
  SFBool colorPerVertex;
  SFBool normalPerVertex;
  SFBool solid;
  TypedSFNode<X3DTextureCoordinateNode> texCoord;

  static void declare(NodeType& type);

 protected:
  void setProperties(RenderMesh& mesh) override;
  std::vector<std::uint32_t> primitives(const FaceList& faces, std::span<const Vec3f> points) override;
  double smoothAngle() override;
  /// Faces may only be cut as fans if they are.
  virtual bool areFacesConvex() { return true; }
  /// A corner whose normal and colour have the number of its point or of its face.
  Corner corner(std::int32_t point, std::size_t face);
};

}  // namespace pleura
