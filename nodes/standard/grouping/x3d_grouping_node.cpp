#include <algorithm>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/grouping/x3d_grouping_node.h>

namespace pleura {

void X3DGroupingNode::declare(NodeType& type) {
  Node::declare(type);
  X3DBoundedObject::declare(type);
  using enum Access;
  type.field<&X3DGroupingNode::children>("children", inputOutput, {}).means("the nodes inside");
  type.field<&X3DGroupingNode::addChildren>("addChildren", inputOnly, {})
      .means("nodes to be added to the children");
  type.field<&X3DGroupingNode::removeChildren>("removeChildren", inputOnly, {})
      .means("nodes to be taken from the children");
}

void X3DGroupingNode::onInitialize() { onChildren_.hears(*this, addChildren, removeChildren); }

void X3DGroupingNode::changeChildren() {
  auto nodes = children.getValue();
  const auto has = [](const std::vector<NodePtr>& list, const NodePtr& node) {
    return std::find(list.begin(), list.end(), node) != list.end();
  };
  if (onChildren_.heard(addChildren))
    for (const auto& node : addChildren.getValue(id))
      if (!has(nodes, node)) nodes.push_back(node);
  if (onChildren_.heard(removeChildren))
    std::erase_if(nodes, [&](const auto& node) { return has(removeChildren.getValue(id), node); });
  if (nodes != children.getValue()) children.setValue(std::move(nodes));
}

}  // namespace pleura
