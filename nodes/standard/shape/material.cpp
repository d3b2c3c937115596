#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/shape/material.h>

namespace pleura {

void Material::declare(NodeType& type) {
  X3DOneSidedMaterialNode::declare(type);
  type.named("Material", "Shape", 1)
      .containedIn("material")
      .means("a surface that scatters and reflects light");
  using enum Access;
  type.field<&Material::ambientIntensity>("ambientIntensity", inputOutput, 0.2f)
      .within(0, 1)
      .means("share of diffuseColor that ambient light brings out");
  type.field<&Material::ambientTexture>("ambientTexture", inputOutput, {})
      .means("picture that multiplies ambientIntensity");
  type.field<&Material::ambientTextureMapping>("ambientTextureMapping", inputOutput, {})
      .means("which texture coordinates ambientTexture takes");
  type.field<&Material::diffuseColor>("diffuseColor", inputOutput, RGB(0.8f, 0.8f, 0.8f))
      .within(0, 1)
      .means("light scattered to all sides");
  type.field<&Material::diffuseTexture>("diffuseTexture", inputOutput, {})
      .means("picture that multiplies diffuseColor");
  type.field<&Material::diffuseTextureMapping>("diffuseTextureMapping", inputOutput, {})
      .means("which texture coordinates diffuseTexture takes");
  type.field<&Material::emissiveColor>("emissiveColor", inputOutput, RGB::Zero())
      .within(0, 1)
      .means("light of its own");
  type.field<&Material::emissiveTexture>("emissiveTexture", inputOutput, {})
      .means("picture that multiplies emissiveColor");
  type.field<&Material::normalTexture>("normalTexture", inputOutput, {})
      .means("picture of bends in the normals");
  type.field<&Material::occlusionStrength>("occlusionStrength", inputOutput, 1)
      .within(0, 1)
      .means("how much occlusionTexture darkens");
  type.field<&Material::occlusionTexture>("occlusionTexture", inputOutput, {})
      .means("picture of what ambient light does not reach");
  type.field<&Material::occlusionTextureMapping>("occlusionTextureMapping", inputOutput, {})
      .means("which texture coordinates occlusionTexture takes");
  type.field<&Material::shininess>("shininess", inputOutput, 0.2f)
      .within(0, 1)
      .means("sharpness of the highlight: 128 times that is its exponent");
  type.field<&Material::shininessTexture>("shininessTexture", inputOutput, {})
      .means("picture that multiplies shininess");
  type.field<&Material::shininessTextureMapping>("shininessTextureMapping", inputOutput, {})
      .means("which texture coordinates shininessTexture takes");
  type.field<&Material::specularColor>("specularColor", inputOutput, RGB::Zero())
      .within(0, 1)
      .means("light reflected as by a mirror");
  type.field<&Material::specularTexture>("specularTexture", inputOutput, {})
      .means("picture that multiplies specularColor");
  type.field<&Material::specularTextureMapping>("specularTextureMapping", inputOutput, {})
      .means("which texture coordinates specularTexture takes");
  type.field<&Material::transparency>("transparency", inputOutput, 0)
      .within(0, 1)
      .means("0 opaque to 1 not seen");
}

}  // namespace pleura
