#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/networking/inline.h>

namespace pleura {

void Inline::declare(NodeType& type) {
  Node::declare(type);
  X3DBoundedObject::declare(type);
  X3DUrlObject::declare(type);
  type.named("Inline", "Networking", 2).means("the scene of another file");
  using enum Access;
  type.field<&Inline::global>("global", inputOutput, false)
      .means("whether what it holds works outside of it");
}

}  // namespace pleura
