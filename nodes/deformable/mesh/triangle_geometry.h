#pragma once

#include <optional>

#include <Eigen/Core>

namespace pleura {

/// A triangle's corners as columns [m]. What follows holds for triangles without area too.
using Corners = Eigen::Matrix3d;

/// A point sum weights[k] * corner k, and its distance squared [m^2] from the asked point.
struct TrianglePoint {
  Eigen::Vector3d point;
  Eigen::Vector3d weights;
  double squaredDistance;
};

/// The triangle's point nearest to p. Weights are exactly 0 off the edges and corners it lies on.
TrianglePoint closestPointOnTriangle(const Corners& corners, const Eigen::Vector3d& p);

/// A ray with what all its triangles share (Woop, Benthin & Wald 2013, Watertight Ray/Triangle Intersection).
class Ray {
 public:
  Ray(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

  const Eigen::Vector3d& origin() const { return origin_; }
  const Eigen::Vector3d& direction() const { return direction_; }

  struct Hit {
    double t;  // in lengths of the direction
    Eigen::Vector3d weights;
  };

  /// Where the line meets the triangle, from either side and in either direction; nothing if it lies edge on.
  std::optional<Hit> meet(const Corners& corners) const;

 private:
  Eigen::Vector3d origin_;
  Eigen::Vector3d direction_;
  int kx_, ky_, kz_;
  Eigen::Vector3d shear_;  // Sx, Sy, Sz
};

}  // namespace pleura
