#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/shape/x3d_one_sided_material_node.h>

namespace pleura {

void X3DOneSidedMaterialNode::declare(NodeType& type) {
  Node::declare(type);
  using enum Access;
  type.field<&X3DOneSidedMaterialNode::emissiveTextureMapping>("emissiveTextureMapping", inputOutput, {})
      .means("which texture coordinates emissiveTexture takes");
  type.field<&X3DOneSidedMaterialNode::normalScale>("normalScale", inputOutput, 1)
      .atLeast(0)
      .means("how much normalTexture bends the normals");
  type.field<&X3DOneSidedMaterialNode::normalTextureMapping>("normalTextureMapping", inputOutput, {})
      .means("which texture coordinates normalTexture takes");
}

}  // namespace pleura
