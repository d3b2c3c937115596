#pragma once

#include <Eigen/Core>

namespace pleura::haptics {

/// A triangle's corners as columns [m].
using Corners = Eigen::Matrix3d;

/// A place on a triangle: point = sum weights[k] * corner k. Weights are exactly 0 off the edges and corners
/// that it lies on.
struct TrianglePoint {
  Eigen::Vector3d point;
  Eigen::Vector3d weights;
};

/// The triangle's point nearest to p (Ericson 2005, Real-Time Collision Detection, 5.1.5). A triangle without
/// area counts as its edges.
TrianglePoint nearestOnTriangle(const Corners& corners, const Eigen::Vector3d& p);

}  // namespace pleura::haptics
