#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// All three corners are points of [0, pointCount).
bool isInRange(const Eigen::Vector3i& triangle, std::size_t pointCount);

/// Two corners are the same point.
bool repeatsPoint(const Eigen::Vector3i& triangle);

/// All three corners are finite.
bool isFinite(const Eigen::Vector3i& triangle, std::span<const Eigen::Vector3f> points);

/// The corners lie in a line: the angle at the first is within 1e-6 rad of 0 or pi, or a side has no length.
bool isFlat(const Eigen::Vector3i& triangle, std::span<const Eigen::Vector3f> points);

/// For each triangle whether others have the same three points.
struct Twins {
  std::vector<bool> repeated;  // an earlier one runs through them in the same sense
  std::vector<int> opposite;   // the one it is back to back with: the first of the other sense; -1: none
};
Twins twins(std::span<const Eigen::Vector3i> triangles);

}  // namespace pleura
