#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/shape/shape.h>

namespace pleura {

void Shape::declare(NodeType& type) {
  X3DShapeNode::declare(type);
  type.named("Shape", "Shape", 1).means("a geometry and how it looks");
}

}  // namespace pleura
