#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// A surface as flat arrays, what every kernel of Pleura takes and gives. Right-handed triangles face
/// outwards.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> points;     // [m]
  std::vector<Eigen::Vector3i> triangles;  // indices into points, three a triangle
};

}  // namespace pleura
