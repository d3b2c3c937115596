#pragma once

#include <Eigen/Geometry>

namespace pleura {

/// Contraction of the diaphragm at an inflation, both 0 at FRC and 1 at TLC: c = i (1 + 0.4 (1 - i)). The
/// diaphragm leads: 1/7 of the breath takes 19 % of its way (1.8 of 7.0 cm in Boussuges 2009 are 26 %).
/// Throws std::invalid_argument when the inflation is not finite.
double diaphragmContraction(double inflation);

/// How the central tendon moves from FRC to TLC: a piston that tilts, its back going down more than its
/// front.
struct DomeMotion {
  double descent = 0.080;   // [m] of the tendon's centre
  double forward = 0.020;   // [m] of the tendon's centre
  double tilt = 0.15;       // [rad] about the left-right axis
  double foldDrop = 0.080;  // [m] of the fold along the wall, where the zone of apposition is long enough
};

/// Rigid motion of the tendon whose centre at rest is `centre`. Throws std::invalid_argument when the
/// contraction is not finite.
Eigen::Isometry3d tendonMotion(const DomeMotion& dome, const Eigen::Vector3d& centre, double contraction);

}  // namespace pleura
