#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// For each point the first point no farther than `distance` [m] that stands for it; itself if there is none
/// or it isn't finite. 0 joins equal points only. Linear. Throws std::invalid_argument on a distance that is
/// negative, not finite, or above 0 but under 1e-12 m.
std::vector<int> weldedPoints(std::span<const Eigen::Vector3f> points, double distance);

}  // namespace pleura
