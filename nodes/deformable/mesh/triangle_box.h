#pragma once

#include <Eigen/Core>

#include <pleura/nodes/deformable/mesh/triangle_geometry.h>

namespace pleura {

/// Whether the triangle and the cube of `half` [m] around `centre` have a point in common (13 separating
/// axes, Akenine-Moeller 2001). Triangles without area count as the line or point they are.
bool meetsCube(const Corners& corners, const Eigen::Vector3d& centre, double half);

}  // namespace pleura
