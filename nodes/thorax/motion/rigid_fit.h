#pragma once

#include <span>

#include <Eigen/Geometry>

namespace pleura {

/// The rigid motion that takes `from` nearest to `to` in the sense of least squares: argmin sum |R a + t -
/// b|^2 (Kabsch 1976, Umeyama 1991). Points that leave the turn undetermined (fewer than three, or on a line)
/// get some minimiser. Throws std::invalid_argument when the sizes differ, are zero, or a point is not
/// finite.
Eigen::Isometry3d fitRigid(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to);

}  // namespace pleura
