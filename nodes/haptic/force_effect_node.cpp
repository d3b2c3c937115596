#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/force_effect_node.h>

namespace pleura {

void ForceEffectNode::declare(NodeType& type) {
  Node::declare(type);
  using enum Access;
  type.field<&ForceEffectNode::enabled>("enabled", inputOutput, true).means("whether there is a force");
}

std::optional<haptics::ForceEffect> ForceEffectNode::effect(const Matrix4f& toWorld) {
  if (!enabled.getValue()) return std::nullopt;
  return haptics::ForceEffect{.id = 0, .kind = kindOf(toWorld)};
}

void ForceEffectNode::report(const Vec3f&, bool) {}

}  // namespace pleura
