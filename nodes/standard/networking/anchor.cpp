#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/networking/anchor.h>

namespace pleura {

void Anchor::declare(NodeType& type) {
  X3DGroupingNode::declare(type);
  X3DUrlObject::declare(type);
  type.named("Anchor", "Networking", 2).means("children that lead somewhere when clicked");
  using enum Access;
  type.field<&Anchor::parameter>("parameter", inputOutput, {})
      .means("words for the program that shows the link");
}

}  // namespace pleura
