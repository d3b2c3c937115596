#pragma once

#include <array>

#include <Eigen/Geometry>

namespace pleura {

/// How far a rib turns about its costovertebral joint from FRC (inflation 0) to TLC (inflation 1).
struct RibAngles {
  double pump = 0.0;    // [rad] about the left-right axis; positive raises the front end
  double bucket = 0.0;  // [rad] about the dorso-ventral axis; positive raises the lateral side
  double side = 0.0;    // +1 left, -1 right, 0 midline (no bucket)
};

/// Pump and bucket amplitudes of ribs 1-12 of one side, [rad]. Ribs 2-9: Wilson et al. 2001, five subjects.
/// Rib 1: rib 2 times the thesis' ratio of rib 1 to 2. Rib 10: as rib 9. Ribs 11, 12: callipers, the bucket
/// of rib 9 without pump, which swings their steep tips outwards.
std::array<RibAngles, 12> measuredRibAngles(double side);

/// The amplitudes of Jacob's thesis (2008) for ribs 1-11, [rad]; rib 12 as rib 11.
std::array<RibAngles, 12> thesisRibAngles(double side);

/// R = Rz(side bucket i) Rx(-pump i) in X3D's frame (+X left, +Y up, +Z front): pump first, then bucket.
/// Throws std::invalid_argument when an angle, the side or the inflation is not finite.
Eigen::Matrix3d ribRotation(const RibAngles& angles, double inflation);

/// The isometry that turns by `rotation` about `centre`: p' = R (p - c) + c.
Eigen::Isometry3d rotationAbout(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& centre);

}  // namespace pleura
