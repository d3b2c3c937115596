#include <cmath>

#include <pleura/nodes/deformable/springs/spring_start.h>

namespace pleura {

Eigen::Isometry3d carryRigidly(std::span<const Eigen::Vector3d> rest, std::span<const int> driven,
                               std::span<const Eigen::Vector3d> targets) {
  constexpr int kMaxTurns = 1000;          // fewer unless the points are nearly in a line
  constexpr double kSmallestTurn = 1e-12;  // [rad]
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (driven.empty()) return motion;
  Eigen::Vector3d a = Eigen::Vector3d::Zero(), b = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < driven.size(); ++i) {
    a += rest[driven[i]];
    b += targets[i];
  }
  a /= static_cast<double>(driven.size());
  b /= static_cast<double>(driven.size());
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < driven.size(); ++i) c += (targets[i] - b) * (rest[driven[i]] - a).transpose();

  // With columns r_k of R and c_k of C, turn R by  sum(r_k x c_k) / |sum r_k . c_k|.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  for (int turn = 0; turn < kMaxTurns; ++turn) {
    const Eigen::Matrix3d r = rotation.toRotationMatrix();
    Eigen::Vector3d torque = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) torque += r.col(k).cross(c.col(k));
    const double along = std::abs(r.cwiseProduct(c).sum()), size = torque.norm();
    if (size <= kSmallestTurn * along) break;
    const double angle = std::atan2(size, along);
    rotation = Eigen::AngleAxisd(angle, torque / size) * rotation;
    rotation.normalize();
  }
  motion.linear() = rotation.toRotationMatrix();
  motion.translation() = b - motion.linear() * a;
  return motion;
}

}  // namespace pleura
