#pragma once

#include <pleura/nodes/standard/core/field_watch.h>
#include <pleura/nodes/standard/rendering/x3d_geometry_node.h>

namespace pleura {

/// A cone along the y axis, its tip on top.
class Cone : public X3DGeometryNode {
 public:
  SFBool bottom;
  SFFloat bottomRadius;
  SFFloat height;
  SFBool side;
  SFBool solid;

  static void declare(NodeType& type);

 protected:
  void updateMesh(RenderMesh& mesh) override;

 private:
  FieldWatch watch_;
};

}  // namespace pleura
