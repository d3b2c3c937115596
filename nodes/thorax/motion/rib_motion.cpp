#include <cmath>
#include <numbers>
#include <stdexcept>

#include <pleura/nodes/thorax/motion/rib_motion.h>

namespace pleura {
namespace {

using PumpBucket = std::array<double, 2>;

std::array<RibAngles, 12> onSide(const std::array<PumpBucket, 12>& table, double unit, double side) {
  std::array<RibAngles, 12> angles;
  for (std::size_t k = 0; k < table.size(); ++k) angles[k] = {table[k][0] * unit, table[k][1] * unit, side};
  return angles;
}

}  // namespace

std::array<RibAngles, 12> measuredRibAngles(double side) {
  constexpr double kPumpOfRib1 = 0.19 / 0.18;  // rib 1 to rib 2 in the thesis
  constexpr double kBucketOfRib1 = 0.10 / 0.12;
  constexpr std::array<PumpBucket, 12> kDegrees{{{14.3 * kPumpOfRib1, 13.7 * kBucketOfRib1},
                                                 {14.3, 13.7},
                                                 {11.4, 13.3},
                                                 {10.7, 10.1},
                                                 {9.6, 8.9},
                                                 {9.4, 6.9},
                                                 {7.9, 6.6},
                                                 {7.9, 6.2},
                                                 {6.0, 6.3},
                                                 {6.0, 6.3},
                                                 {0.0, 6.3},
                                                 {0.0, 6.3}}};
  return onSide(kDegrees, std::numbers::pi / 180.0, side);
}

std::array<RibAngles, 12> thesisRibAngles(double side) {
  constexpr std::array<PumpBucket, 12> kRadians{{{0.19, 0.10},
                                                 {0.18, 0.12},
                                                 {0.16, 0.15},
                                                 {0.14, 0.17},
                                                 {0.12, 0.19},
                                                 {0.12, 0.20},
                                                 {0.10, 0.21},
                                                 {0.08, 0.22},
                                                 {0.04, 0.23},
                                                 {0.03, 0.24},
                                                 {0.02, 0.24},
                                                 {0.02, 0.24}}};
  return onSide(kRadians, 1.0, side);
}

Eigen::Matrix3d ribRotation(const RibAngles& angles, double inflation) {
  if (!std::isfinite(angles.pump) || !std::isfinite(angles.bucket) || !std::isfinite(angles.side)) {
    throw std::invalid_argument("ribRotation: angles must be finite");
  }
  if (!std::isfinite(inflation)) throw std::invalid_argument("ribRotation: inflation must be finite");
  const Eigen::AngleAxisd pump(-angles.pump * inflation, Eigen::Vector3d::UnitX());
  const Eigen::AngleAxisd bucket(angles.side * angles.bucket * inflation, Eigen::Vector3d::UnitZ());
  return bucket.toRotationMatrix() * pump.toRotationMatrix();
}

Eigen::Isometry3d rotationAbout(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& centre) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = rotation;
  motion.translation() = centre - rotation * centre;
  return motion;
}

}  // namespace pleura
