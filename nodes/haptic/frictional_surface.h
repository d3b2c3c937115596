#pragma once

#include <pleura/nodes/haptic/haptic_surface_node.h>

namespace pleura {

/// A surface that holds the tip until it is pulled hard enough, and brakes it from then on (Coulomb).
class FrictionalSurface : public HapticSurfaceNode {
 public:
  SFFloat staticFriction;
  SFFloat dynamicFriction;

  haptics::TouchSurface surfaceOn(double stiffness, double damping) override;

  static void declare(NodeType& type);
};

}  // namespace pleura
