#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace pleura::haptics {

/// What stays of a touchable surface while it deforms: its triangles and the shape of the tree of boxes about
/// them. Immutable, shared by all its frames and both threads.
class TouchMesh {
 public:
  /// Throws std::invalid_argument on no triangles, indices out of range and points that are not finite.
  /// Triangles without area are kept out of the tree. O(n log n).
  TouchMesh(std::span<const Eigen::Vector3f> points, std::span<const Eigen::Vector3i> triangles);
};

/// The points of a surface at one moment [m], and the tree's boxes about them.
struct TouchMeshFrame {
  std::vector<Eigen::Vector3f> points;

  /// As many points as the mesh has. Linear; allocates only when the frame served a smaller mesh before.
  /// Throws std::invalid_argument on points that are not finite or of another number, the frame untouched.
  void fit(const TouchMesh& mesh, std::span<const Eigen::Vector3f> moved);
};

}  // namespace pleura::haptics
