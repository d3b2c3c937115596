#include <pleura/nodes/core/node.h>
#include <pleura/nodes/core/node_type.h>

namespace pleura {

std::string Node::describe() const { return name_.empty() ? type().name() : name_; }

Field* Node::getField(std::string_view field) {
  const NodeField* found = type().find(field);
  return found != nullptr ? &found->of(*this) : nullptr;
}

void Node::initialize(SceneContext& context) {
  if (isInitialized()) return;
  context_ = &context;
  for (const auto& field : type().fields())
    if (field->access == Access::initializeOnly) field->of(*this).setAccessType(Access::outputOnly);
  onInitialize();
}

void Node::declare(NodeType& type) {
  type.field<&Node::metadata>("metadata", Access::inputOutput, {}).means("information about the node");
}

}  // namespace pleura
