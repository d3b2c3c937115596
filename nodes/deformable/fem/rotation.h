#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pleura {

/// The rotation R that maximises tr(R^T F), a rotation whatever F is: of the polar decomposition F = R S when
/// det F > 0, and with the least stretch of S negative when F mirrors (Irving, Teran and Fedkiw 2004). Where
/// many are as good (F maps to a line, or to a point) it is one of them. F must be finite and within 1e60.
Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& F);

/// det(F) F^-T, the derivative of det F, of any F.
inline Eigen::Matrix3d cofactor(const Eigen::Matrix3d& F) {
  Eigen::Matrix3d c;
  c.col(0) = F.col(1).cross(F.col(2));
  c.col(1) = F.col(2).cross(F.col(0));
  c.col(2) = F.col(0).cross(F.col(1));
  return c;
}

}  // namespace pleura
