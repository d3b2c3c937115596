#pragma once

#include <span>

#include <Eigen/Core>

namespace pleura::planar {

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The bilinear form of which area(p) = B(p, p): B(p, r) = 1/2 sum_k p_k x r_k+1 [m^2], round a closed ring.
double areaForm(std::span<const Eigen::Vector2d> p, std::span<const Eigen::Vector2d> r);

/// Signed area [m^2], positive counter-clockwise.
double area(std::span<const Eigen::Vector2d> ring);

/// d area / d p_k [m].
Eigen::Vector2d areaGradient(std::span<const Eigen::Vector2d> ring, std::size_t k);

/// Centre of the enclosed area [m], which must not be zero.
Eigen::Vector2d centroid(std::span<const Eigen::Vector2d> ring);

}  // namespace pleura::planar
