#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace pleura {

/// All three corners are points of [0, pointCount).
bool isInRange(const Eigen::Vector3i& triangle, std::size_t pointCount);

/// Two corners are the same point.
bool repeatsPoint(const Eigen::Vector3i& triangle);

/// All three corners are finite.
bool isFinite(const Eigen::Vector3i& triangle, std::span<const Eigen::Vector3f> points);

/// The corners lie in a line: the angle at the first is within 1e-6 rad of 0 or pi, or a side has no length.
bool isFlat(const Eigen::Vector3i& triangle, std::span<const Eigen::Vector3f> points);

/// For each triangle whether an earlier one has the same three points, in whatever order.
std::vector<bool> duplicates(std::span<const Eigen::Vector3i> triangles);

}  // namespace pleura
