#pragma once

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

namespace pleura {

/// Smooth displacements for the points of a surface that nothing drives: the harmonic extension of the driven
/// ones over the graph of its edges, weighted by inverse length. Factorised once, two triangular solves a call.
class HarmonicFill {
 public:
  /// `driven` has one flag a point. Points that no path of edges joins to a driven one stay at rest. Throws
  /// std::invalid_argument when sizes or indices do not fit the mesh.
  HarmonicFill(const TriangleMesh& mesh, const std::vector<bool>& driven);

  /// Overwrites the free rows of `displacement` (one row a point) from its driven rows. Does not allocate.
  void fill(Eigen::MatrixX3d& displacement);

  int freeCount() const { return static_cast<int>(free_.size()); }

 private:
  std::vector<int> free_;    // points, in the order of the factor
  std::vector<int> driven_;  // points, in the order of coupling_'s columns
  Eigen::SparseMatrix<double, Eigen::RowMajor> coupling_;  // rows as free_
  Eigen::SparseMatrix<double> factor_;                     // lower Cholesky factor
  Eigen::MatrixX3d boundary_, solution_;
};

}  // namespace pleura
