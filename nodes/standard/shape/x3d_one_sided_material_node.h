#pragma once

#include <pleura/nodes/standard/shape/x3d_material_node.h>

namespace pleura {

/// A material that is the same for both sides, or for one of them.
class X3DOneSidedMaterialNode : public X3DMaterialNode {
 public:
  SFString emissiveTextureMapping;
  SFFloat normalScale;
  SFString normalTextureMapping;

  static void declare(NodeType& type);
};

}  // namespace pleura
