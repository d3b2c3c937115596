#pragma once

#include <Eigen/Core>

namespace pleura {

/// The rotation R that maximises tr(R^T F), a rotation whatever F is: of the polar decomposition F = R S when
/// det F > 0, and with the least stretch of S negative when F mirrors (Irving, Teran and Fedkiw 2004). Where
/// many are as good (F maps to a line, or to a point) it is one of them. F must be finite and within 1e60.
Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& F);

}  // namespace pleura
