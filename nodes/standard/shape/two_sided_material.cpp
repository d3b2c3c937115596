#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/shape/two_sided_material.h>

namespace pleura {

void TwoSidedMaterial::declare(NodeType& type) {
  Node::declare(type);
  type.named("TwoSidedMaterial", "Shape", 4)
      .containedIn("material")
      .means("a material for each side of a surface; deprecated in X3D 4.0 for backMaterial");
  using enum Access;
  type.field<&TwoSidedMaterial::ambientIntensity>("ambientIntensity", inputOutput, 0.2f)
      .within(0, 1)
      .means("share of diffuseColor that ambient light brings out");
  type.field<&TwoSidedMaterial::backAmbientIntensity>("backAmbientIntensity", inputOutput, 0.2f)
      .within(0, 1)
      .means("ambientIntensity of the back");
  type.field<&TwoSidedMaterial::backDiffuseColor>("backDiffuseColor", inputOutput, RGB(0.8f, 0.8f, 0.8f))
      .within(0, 1)
      .means("diffuseColor of the back");
  type.field<&TwoSidedMaterial::backEmissiveColor>("backEmissiveColor", inputOutput, RGB::Zero())
      .within(0, 1)
      .means("emissiveColor of the back");
  type.field<&TwoSidedMaterial::backShininess>("backShininess", inputOutput, 0.2f)
      .within(0, 1)
      .means("shininess of the back");
  type.field<&TwoSidedMaterial::backSpecularColor>("backSpecularColor", inputOutput, RGB::Zero())
      .within(0, 1)
      .means("specularColor of the back");
  type.field<&TwoSidedMaterial::backTransparency>("backTransparency", inputOutput, 0)
      .within(0, 1)
      .means("transparency of the back");
  type.field<&TwoSidedMaterial::diffuseColor>("diffuseColor", inputOutput, RGB(0.8f, 0.8f, 0.8f))
      .within(0, 1)
      .means("light scattered to all sides");
  type.field<&TwoSidedMaterial::emissiveColor>("emissiveColor", inputOutput, RGB::Zero())
      .within(0, 1)
      .means("light of its own");
  type.field<&TwoSidedMaterial::separateBackColor>("separateBackColor", inputOutput, false)
      .means("whether the back has its own material");
  type.field<&TwoSidedMaterial::shininess>("shininess", inputOutput, 0.2f)
      .within(0, 1)
      .means("sharpness of the highlight: 128 times that is its exponent");
  type.field<&TwoSidedMaterial::specularColor>("specularColor", inputOutput, RGB::Zero())
      .within(0, 1)
      .means("light reflected as by a mirror");
  type.field<&TwoSidedMaterial::transparency>("transparency", inputOutput, 0)
      .within(0, 1)
      .means("0 opaque to 1 not seen");
}

}  // namespace pleura
