#pragma once

#include <pleura/haptics/contact/touch_surface.h>
#include <pleura/nodes/standard/shape/x3d_surface_node.h>

namespace pleura {

/// A surface whose stiffness and damping are parts of what the device can do (H3D's useRelativeValues).
class HapticSurfaceNode : public X3DSurfaceNode {
 public:
  SFFloat stiffness;
  SFFloat damping;

  /// How it feels on a device that can render at most `stiffness` [N/m] and `damping` [N s/m] stably.
  virtual haptics::TouchSurface surfaceOn(double stiffness, double damping);

  static void declare(NodeType& type);
};

}  // namespace pleura
