#pragma once

#include <pleura/nodes/standard/shape/x3d_material_node.h>

namespace pleura {

/// A material for each side of a surface; deprecated in X3D 4.0 for backMaterial.
class TwoSidedMaterial : public X3DMaterialNode {
 public:
  SFFloat ambientIntensity;
  SFFloat backAmbientIntensity;
  SFColor backDiffuseColor;
  SFColor backEmissiveColor;
  SFFloat backShininess;
  SFColor backSpecularColor;
  SFFloat backTransparency;
  SFColor diffuseColor;
  SFColor emissiveColor;
  SFBool separateBackColor;
  SFFloat shininess;
  SFColor specularColor;
  SFFloat transparency;

  static void declare(NodeType& type);
};

}  // namespace pleura
