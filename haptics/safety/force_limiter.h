#pragma once

#include <pleura/haptics/safety/finite.h>

namespace pleura::haptics {

/// The force [N], or torque [N m], that may leave for a device that takes at most `limit` >= 0:
///   F' = F min(1, limit / |F|)
/// so its direction is kept. What is not finite becomes zero: no part of it can be trusted.
inline Eigen::Vector3d limited(const Eigen::Vector3d& force, double limit) {
  if (!isFinite(force)) return Eigen::Vector3d::Zero();
  const double largest = force.cwiseAbs().maxCoeff();
  if (largest == 0) return force;
  const Eigen::Vector3d scaled = force / largest;  // so that no square overflows
  const double norm = scaled.norm();
  return largest <= limit / norm ? force : Eigen::Vector3d(scaled * (limit / norm));
}

}  // namespace pleura::haptics
