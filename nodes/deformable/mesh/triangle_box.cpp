#include <cmath>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/mesh/triangle_box.h>

namespace pleura {

bool meetsCube(const Corners& corners, const Eigen::Vector3d& centre, double half) {
  const Corners v = corners.colwise() - centre;
  const auto isApartAlong = [&](const Eigen::Vector3d& axis) {
    const Eigen::Vector3d along = v.transpose() * axis;
    const double reach = half * axis.cwiseAbs().sum();
    return along.minCoeff() > reach || along.maxCoeff() < -reach;
  };
  if ((v.rowwise().minCoeff().array() > half).any() || (v.rowwise().maxCoeff().array() < -half).any())
    return false;
  const Eigen::Vector3d sides[3] = {v.col(1) - v.col(0), v.col(2) - v.col(1), v.col(0) - v.col(2)};
  if (isApartAlong(sides[0].cross(sides[1]))) return false;
  for (const Eigen::Vector3d& side : sides)
    for (int axis = 0; axis < 3; ++axis)
      if (isApartAlong(Eigen::Vector3d::Unit(axis).cross(side))) return false;
  return true;
}

}  // namespace pleura
