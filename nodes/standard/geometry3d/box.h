#pragma once

#include <pleura/nodes/standard/core/field_watch.h>
#include <pleura/nodes/standard/rendering/x3d_geometry_node.h>

namespace pleura {

/// A box around the origin.
class Box : public X3DGeometryNode {
 public:
  SFVec3f size;
  SFBool solid;

  static void declare(NodeType& type);

 protected:
  void updateMesh(RenderMesh& mesh) override;

 private:
  FieldWatch watch_;
};

}  // namespace pleura
