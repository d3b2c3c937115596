#pragma once

#include <pleura/nodes/haptic/frictional_surface.h>

namespace pleura {

/// A surface that draws the tip to itself from near by and holds it.
class MagneticSurface : public FrictionalSurface {
 public:
  SFFloat snapDistance;

  haptics::TouchSurface surfaceOn(double stiffness, double damping) override;

  static void declare(NodeType& type);
};

}  // namespace pleura
