#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/grouping/switch.h>

namespace pleura {

void Switch::declare(NodeType& type) {
  X3DGroupingNode::declare(type);
  type.named("Switch", "Grouping", 2).means("one of its children, or none");
  using enum Access;
  type.field<&Switch::whichChoice>("whichChoice", inputOutput, -1)
      .atLeast(-1)
      .means("number of the child that is shown, from 0; -1: none");
}

std::span<const NodePtr> Switch::shown() {
  const std::span<const NodePtr> all = children.getValue();
  const auto chosen = whichChoice.getValue();
  if (chosen < 0 || static_cast<std::size_t>(chosen) >= all.size()) return {};
  return all.subspan(static_cast<std::size_t>(chosen), 1);
}

}  // namespace pleura
