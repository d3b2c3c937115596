#pragma once

#include <span>

#include <Eigen/Core>

namespace pleura {

/// Adds the forces [N] of a pressure p [Pa] inside a surface to those at its points: each triangle's p A n
/// goes to its corners in equal parts. For a closed surface f = p dV/dx, of no net force and no net moment.
/// `forces` is as long as `points` [m]; indices must be in range. Nothing is allocated.
void addPressureForces(double pressure, std::span<const Eigen::Vector3d> points,
                       std::span<const Eigen::Vector3i> triangles, std::span<Eigen::Vector3d> forces);

}  // namespace pleura
