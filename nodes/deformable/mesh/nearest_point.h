#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include <Eigen/Core>

namespace pleura {

/// The index of the one of `points` (at least one) that is nearest to `place`; of several as near, the first.
inline std::size_t nearestPoint(std::span<const Eigen::Vector3f> points, const Eigen::Vector3f& place) {
  const auto nearest = std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
    return (a - place).squaredNorm() < (b - place).squaredNorm();
  });
  return static_cast<std::size_t>(nearest - points.begin());
}

}  // namespace pleura
