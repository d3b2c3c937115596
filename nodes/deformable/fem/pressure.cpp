#include <cassert>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/fem/pressure.h>

namespace pleura {

void addPressureForces(double pressure, std::span<const Eigen::Vector3d> points,
                       std::span<const Eigen::Vector3i> triangles, std::span<Eigen::Vector3d> forces) {
  assert(forces.size() == points.size());
  for (const Eigen::Vector3i& triangle : triangles) {
    const Eigen::Vector3d& a = points[triangle[0]];
    // p A n / 3 = p / 6 (b - a) x (c - a)
    const Eigen::Vector3d share = pressure / 6 * (points[triangle[1]] - a).cross(points[triangle[2]] - a);
    for (const int corner : triangle) forces[corner] += share;
  }
}

}  // namespace pleura
