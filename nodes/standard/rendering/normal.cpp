#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/normal.h>

namespace pleura {

void Normal::declare(NodeType& type) {
  Node::declare(type);
  type.named("Normal", "Rendering", 2).containedIn("normal").means("normals of a geometry");
  using enum Access;
  type.field<&Normal::vector>("vector", inputOutput, {}).within(-1, 1).means("unit normals");
}

}  // namespace pleura
