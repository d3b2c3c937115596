#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/grouping/group.h>

namespace pleura {

void Group::declare(NodeType& type) {
  X3DGroupingNode::declare(type);
  type.named("Group", "Grouping", 1).means("children in order");
}

}  // namespace pleura
