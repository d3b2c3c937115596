#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Core>

namespace pleura {

/// Lengths beyond this [m] are refused or cut to it: sums of a few of them stay finite in float.
inline constexpr float kChainmailFarthest = 1e30f;

/// Throws std::invalid_argument unless point i of `name` is finite and within that range. NaN is found
/// without a comparison, which would raise a floating-point exception.
inline void requireInChainmailRange(const char* name, int i, const Eigen::Vector3f& point) {
  for (const float x : point)
    if (!std::isfinite(x) || std::abs(x) > kChainmailFarthest)
      throw std::invalid_argument("chainmail: " + std::string(name) + " " + std::to_string(i) +
                                  " is not finite, or too far away");
}

}  // namespace pleura
