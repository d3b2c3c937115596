#pragma once

namespace pleura::haptics {

/// How a surface feels, in absolute figures: the scene's relative ones times what the device can do.
struct TouchSurface {
  double stiffness = 0;         // [N/m]
  double damping = 0;           // [N s/m] along the normal
  double staticFriction = 0;    // of the normal force
  double dynamicFriction = 0;   // of the normal force, at most staticFriction
  double magneticDistance = 0;  // [m] from which the surface pulls the tip to itself; 0: it does not
  bool twoSided = false;        // felt from behind too
};

}  // namespace pleura::haptics
