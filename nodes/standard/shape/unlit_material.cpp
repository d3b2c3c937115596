#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/shape/unlit_material.h>

namespace pleura {

void UnlitMaterial::declare(NodeType& type) {
  X3DOneSidedMaterialNode::declare(type);
  type.named("UnlitMaterial", "Shape", 1)
      .containedIn("material")
      .means("a surface that shines the same under any light");
  using enum Access;
  type.field<&UnlitMaterial::emissiveColor>("emissiveColor", inputOutput, RGB(1, 1, 1))
      .within(0, 1)
      .means("light of its own");
  type.field<&UnlitMaterial::emissiveTexture>("emissiveTexture", inputOutput, {})
      .means("picture that multiplies emissiveColor");
  type.field<&UnlitMaterial::normalTexture>("normalTexture", inputOutput, {})
      .means("picture of bends in the normals");
  type.field<&UnlitMaterial::transparency>("transparency", inputOutput, 0)
      .within(0, 1)
      .means("0 opaque to 1 not seen");
}

}  // namespace pleura
