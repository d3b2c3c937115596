#pragma once

#include <pleura/nodes/standard/core/field_watch.h>
#include <pleura/nodes/standard/rendering/x3d_geometry_node.h>

namespace pleura {

/// A cylinder along the y axis.
class Cylinder : public X3DGeometryNode {
 public:
  SFBool bottom;
  SFFloat height;
  SFFloat radius;
  SFBool side;
  SFBool solid;
  SFBool top;

  static void declare(NodeType& type);

 protected:
  void updateMesh(RenderMesh& mesh) override;

 private:
  FieldWatch watch_;
};

}  // namespace pleura
