#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// Smooth displacements for the points of a surface that nothing drives: the harmonic extension of the driven
/// ones over the graph of its edges, weighted by inverse length. Factorised once, two triangular solves a
/// call.
class HarmonicFill {
 public:
  HarmonicFill() = default;

  /// `driven` lists points. Those that no path of edges joins to a driven one stay at rest. Throws
  /// std::invalid_argument when an index does not fit the mesh.
  HarmonicFill(const TriangleMesh& mesh, std::span<const int> driven);

  /// Overwrites the entries of the free points [one a point, m] from those of the driven. Does not allocate.
  void fill(std::span<Eigen::Vector4f> displacement);

  std::size_t freeCount() const { return free_.size(); }

 private:
  /// Sparse columns: entries start[j] .. start[j + 1] of row and value.
  struct Columns {
    std::vector<int> start, row;
    std::vector<float> value;
  };

  std::vector<int> free_;  // points, in the order of the factor
  Columns coupling_;       // a column a free point; rows are driven points
  Columns factor_;         // L below its diagonal
  std::vector<float> inverseDiagonal_;
  std::vector<Eigen::Vector4f> x_;  // workspace, in the order of the factor
};

}  // namespace pleura
