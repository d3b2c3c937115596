#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/haptic_surface_node.h>

namespace pleura {

void HapticSurfaceNode::declare(NodeType& type) {
  Node::declare(type);
  type.containedIn("surface");
  using enum Access;
  type.field<&HapticSurfaceNode::stiffness>("stiffness", inputOutput, 0.5f)
      .within(0, 1)
      .means("part of the device's largest stable stiffness");
  type.field<&HapticSurfaceNode::damping>("damping", inputOutput, 0)
      .within(0, 1)
      .means("part of the device's largest damping");
}

haptics::TouchSurface HapticSurfaceNode::surfaceOn(double most, double mostDamping) {
  return {.stiffness = most * stiffness.getValue(), .damping = mostDamping * damping.getValue()};
}

}  // namespace pleura
