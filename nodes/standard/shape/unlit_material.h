#pragma once

#include <pleura/nodes/standard/shape/x3d_one_sided_material_node.h>

namespace pleura {

/// A surface that shines the same under any light.
class UnlitMaterial : public X3DOneSidedMaterialNode {
 public:
  SFColor emissiveColor;
  SFNode emissiveTexture;
  SFNode normalTexture;
  SFFloat transparency;

  static void declare(NodeType& type);
};

}  // namespace pleura
