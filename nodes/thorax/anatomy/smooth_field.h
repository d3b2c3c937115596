#pragma once

#include <vector>

#include <Eigen/Geometry>

#include <pleura/nodes/thorax/anatomy/implicit_surface.h>

namespace pleura {

/// A function sampled once on a regular grid and read through cubic B-splines: cheap, twice differentiable,
/// and blurred by about 0.6 of the spacing, so that it has no detail that a mesh of that size could not
/// follow.
class SmoothField {
 public:
  /// Throws std::invalid_argument if spacing is not positive.
  SmoothField(const Solid& function, const Eigen::AlignedBox3d& box, double spacing);

  /// Beyond the box the values of its border.
  double operator()(const Eigen::Vector3d& point) const;

 private:
  Eigen::Vector3d origin_;
  double spacing_;
  Eigen::Vector3i nodes_;
  std::vector<double> values_;
};

}  // namespace pleura
