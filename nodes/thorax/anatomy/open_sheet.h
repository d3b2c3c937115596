#pragma once

#include <vector>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// A piece of a closed surface with its border.
struct OpenSheet {
  TriangleMesh mesh;
  std::vector<int> next;  // for a point of the border the one after it, otherwise -1
};

/// The triangles whose corners are all kept, without those that hang on by one edge only and without unused
/// points.
OpenSheet cutOpen(const TriangleMesh& closed, const std::vector<bool>& keep);

/// The point of a closed polyline nearest to a point.
Eigen::Vector3f nearestOnLoop(const std::vector<Eigen::Vector3f>& loop, const Eigen::Vector3f& point);

}  // namespace pleura
