#pragma once

#include <algorithm>
#include <span>

#include <Eigen/Core>

namespace pleura {

// Points are in float where they are shown and in double where forces on them balance. `to` is as long as
// `from`.

inline void inDouble(std::span<const Eigen::Vector3f> from, std::span<Eigen::Vector3d> to) {
  std::transform(from.begin(), from.end(), to.begin(),
                 [](const Eigen::Vector3f& p) { return Eigen::Vector3d(p.cast<double>()); });
}

inline void inFloat(std::span<const Eigen::Vector3d> from, std::span<Eigen::Vector3f> to) {
  std::transform(from.begin(), from.end(), to.begin(),
                 [](const Eigen::Vector3d& p) { return Eigen::Vector3f(p.cast<float>()); });
}

}  // namespace pleura
