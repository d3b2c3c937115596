#pragma once

#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pleura {

/// The rigid motion that takes rest[driven[i]] nearest to targets[i] (least squares): the mean shift, and the
/// turn that their torques lead to from none at all (Mueller et al. 2016, A Robust Method to Extract the
/// Rotational Part of Deformations), so that a turn which the points leave open is not made. Identity for no
/// points. Indices must be in range and points finite.
Eigen::Isometry3d carryRigidly(std::span<const Eigen::Vector3d> rest, std::span<const int> driven,
                               std::span<const Eigen::Vector3d> targets);

}  // namespace pleura
