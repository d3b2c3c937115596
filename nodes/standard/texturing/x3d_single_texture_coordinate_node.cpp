#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/texturing/x3d_single_texture_coordinate_node.h>

namespace pleura {

void X3DSingleTextureCoordinateNode::declare(NodeType& type) {
  Node::declare(type);
  using enum Access;
  type.field<&X3DSingleTextureCoordinateNode::mapping>("mapping", inputOutput, {})
      .means("the name by which a material refers to it");
}

}  // namespace pleura
