#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/grouping/static_group.h>

namespace pleura {

void StaticGroup::declare(NodeType& type) {
  Node::declare(type);
  X3DBoundedObject::declare(type);
  type.named("StaticGroup", "Grouping", 3).means("children that never change");
  using enum Access;
  type.field<&StaticGroup::children>("children", initializeOnly, {}).means("the nodes inside");
}

}  // namespace pleura
