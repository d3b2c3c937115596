#pragma once

#include <pleura/nodes/standard/shape/x3d_one_sided_material_node.h>

namespace pleura {

/// A surface that scatters and reflects light.
class Material : public X3DOneSidedMaterialNode {
 public:
  SFFloat ambientIntensity;
  SFNode ambientTexture;
  SFString ambientTextureMapping;
  SFColor diffuseColor;
  SFNode diffuseTexture;
  SFString diffuseTextureMapping;
  SFColor emissiveColor;
  SFNode emissiveTexture;
  SFNode normalTexture;
  SFFloat occlusionStrength;
  SFNode occlusionTexture;
  SFString occlusionTextureMapping;
  SFFloat shininess;
  SFNode shininessTexture;
  SFString shininessTextureMapping;
  SFColor specularColor;
  SFNode specularTexture;
  SFString specularTextureMapping;
  SFFloat transparency;

  static void declare(NodeType& type);
};

}  // namespace pleura
