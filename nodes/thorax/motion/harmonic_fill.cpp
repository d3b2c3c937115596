#include <pleura/nodes/thorax/motion/harmonic_fill.h>

#include <set>
#include <stdexcept>
#include <utility>

namespace pleura {
namespace {

using Edges = std::set<std::pair<int, int>>;

Edges edgesOf(const TriangleMesh& mesh) {
  Edges edges;
  const int n = static_cast<int>(mesh.points.size());
  for (const Eigen::Vector3i& t : mesh.triangles) {
    if (t.minCoeff() < 0 || t.maxCoeff() >= n) {
      throw std::invalid_argument("HarmonicFill: mesh has a triangle with an index out of range");
    }
    for (int k = 0; k < 3; ++k) {
      const int a = t[k];
      const int b = t[(k + 1) % 3];
      if (a != b) edges.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return edges;
}

constexpr double kShortest = 1e-5;     // [m] edges below count as this long
constexpr double kGround = 1e-9;       // keeps the matrix definite where nothing is driven, [1/m]

}  // namespace

HarmonicFill::HarmonicFill(const TriangleMesh& mesh, const std::vector<bool>& driven) {
  if (driven.size() != mesh.points.size()) {
    throw std::invalid_argument("HarmonicFill: driven must have one flag a point");
  }
  std::vector<int> slot(driven.size());
  for (std::size_t i = 0; i < driven.size(); ++i) {
    std::vector<int>& list = driven[i] ? driven_ : free_;
    slot[i] = static_cast<int>(list.size());
    list.push_back(static_cast<int>(i));
  }

  // sum_j w_ij (d_i - d_j) = 0 for every free i: A d_free = B d_driven
  std::vector<Eigen::Triplet<double>> a;
  std::vector<Eigen::Triplet<double>> b;
  for (std::size_t k = 0; k < free_.size(); ++k) a.emplace_back(static_cast<int>(k), static_cast<int>(k), kGround);
  const auto add = [&](int i, int j, double w) {
    const auto from = static_cast<std::size_t>(i);
    const auto to = static_cast<std::size_t>(j);
    if (driven[from]) return;
    a.emplace_back(slot[from], slot[from], w);
    (driven[to] ? b : a).emplace_back(slot[from], slot[to], driven[to] ? w : -w);
  };
  for (const auto& [i, j] : edgesOf(mesh)) {
    const double length =
        (mesh.points[static_cast<std::size_t>(i)] - mesh.points[static_cast<std::size_t>(j)]).cast<double>().norm();
    const double w = 1.0 / std::max(length, kShortest);
    add(i, j, w);
    add(j, i, w);
  }
  const auto n = static_cast<Eigen::Index>(free_.size());
  const auto m = static_cast<Eigen::Index>(driven_.size());
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(a.begin(), a.end());
  coupling_.resize(n, m);
  coupling_.setFromTriplets(b.begin(), b.end());

  // P A P' = L L'; rows are kept in the factor's order, so that a call needs no permutation.
  if (n > 0) {
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky(matrix);
    coupling_ = (cholesky.permutationP() * Eigen::SparseMatrix<double>(coupling_)).eval();
    factor_ = cholesky.matrixL();
    std::vector<int> ordered(free_.size());
    for (std::size_t k = 0; k < free_.size(); ++k) {
      ordered[static_cast<std::size_t>(cholesky.permutationP().indices()[static_cast<Eigen::Index>(k)])] = free_[k];
    }
    free_ = std::move(ordered);
  }
  boundary_.resize(m, 3);
  solution_.resize(n, 3);
}

void HarmonicFill::fill(Eigen::MatrixX3d& displacement) {
  if (free_.empty()) return;
  for (std::size_t k = 0; k < driven_.size(); ++k) {
    boundary_.row(static_cast<Eigen::Index>(k)) = displacement.row(driven_[k]);
  }
  solution_.noalias() = coupling_ * boundary_;
  factor_.triangularView<Eigen::Lower>().solveInPlace(solution_);
  factor_.transpose().triangularView<Eigen::Upper>().solveInPlace(solution_);
  for (std::size_t k = 0; k < free_.size(); ++k) {
    displacement.row(free_[k]) = solution_.row(static_cast<Eigen::Index>(k));
  }
}

}  // namespace pleura
