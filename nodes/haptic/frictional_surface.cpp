#include <algorithm>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/frictional_surface.h>

namespace pleura {

void FrictionalSurface::declare(NodeType& type) {
  HapticSurfaceNode::declare(type);
  type.named("FrictionalSurface", "Pleura").means("feels hard, and sticks and slips");
  using enum Access;
  type.field<&FrictionalSurface::staticFriction>("staticFriction", inputOutput, 0.4f)
      .within(0, 10)
      .means("sideways force that it holds, of the force into it");
  type.field<&FrictionalSurface::dynamicFriction>("dynamicFriction", inputOutput, 0.3f)
      .within(0, 10)
      .means("sideways force of a tip that slides, of the force into it; at most staticFriction counts");
}

haptics::TouchSurface FrictionalSurface::surfaceOn(double most, double mostDamping) {
  haptics::TouchSurface surface = HapticSurfaceNode::surfaceOn(most, mostDamping);
  surface.staticFriction = staticFriction.getValue();
  surface.dynamicFriction = std::min(dynamicFriction.getValue(), staticFriction.getValue());
  return surface;
}

}  // namespace pleura
