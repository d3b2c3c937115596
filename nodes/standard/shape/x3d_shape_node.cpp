#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/shape/x3d_shape_node.h>

namespace pleura {

void X3DShapeNode::declare(NodeType& type) {
  Node::declare(type);
  X3DBoundedObject::declare(type);
  using enum Access;
  type.field<&X3DShapeNode::appearance>("appearance", inputOutput, {}).means("how the geometry looks");
  type.field<&X3DShapeNode::castShadow>("castShadow", inputOutput, true)
      .means("whether the shape casts shadows");
  type.field<&X3DShapeNode::geometry>("geometry", inputOutput, {}).means("the shape itself");
}

}  // namespace pleura
