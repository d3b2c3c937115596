#pragma once

#include <Eigen/Geometry>

namespace pleura {

/// How the central tendon moves from FRC to TLC: a piston that tilts, its back going down more than its front.
struct DomeMotion {
  double descent = 0.075;  // [m] of the tendon's centre; a quiet breath (inflation 1/7) takes 1.1 cm
  double forward = 0.010;  // [m] of the tendon's centre
  double tilt = 0.15;      // [rad] about the left-right axis
  double foldDrop = 0.070; // [m] of the fold along the wall, where the zone of apposition is long enough
};

/// Rigid motion of the tendon whose centre at rest is `centre`. Throws std::invalid_argument when the inflation
/// is not finite.
Eigen::Isometry3d tendonMotion(const DomeMotion& dome, const Eigen::Vector3d& centre, double inflation);

}  // namespace pleura
