#pragma once

#include <pleura/nodes/standard/rendering/x3d_composed_geometry_node.h>

namespace pleura {

/// Polygons that share points.
class IndexedFaceSet : public X3DComposedGeometryNode {
 public:
  MFInt32 colorIndex;
  SFBool convex;
  MFInt32 coordIndex;
  SFFloat creaseAngle;
  MFInt32 normalIndex;
  MFInt32 texCoordIndex;
  MFInt32 set_colorIndex;
  MFInt32 set_coordIndex;
  MFInt32 set_normalIndex;
  MFInt32 set_texCoordIndex;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;
  bool topologyChanged() override;
  void collect(std::size_t pointCount, FaceList& faces) override;
  bool areFacesConvex() override { return convex.getValue(); }
  double smoothAngle() override { return normalPerVertex.getValue() ? creaseAngle.getValue() : 0; }

 private:
  FieldWatch topology_;
};

}  // namespace pleura
