#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include <Eigen/SparseCholesky>

#include <pleura/nodes/thorax/motion/harmonic_fill.h>

namespace pleura {
namespace {

constexpr double kShortest = 1e-5;  // [m] shorter edges count as this long
constexpr double kGround = 1e-9;    // [1/m] keeps the matrix definite where nothing is driven

using Matrix = Eigen::SparseMatrix<double>;

std::set<std::pair<int, int>> edgesOf(const TriangleMesh& mesh) {
  std::set<std::pair<int, int>> edges;
  const int n = static_cast<int>(mesh.points.size());
  for (const Eigen::Vector3i& t : mesh.triangles) {
    if (t.minCoeff() < 0 || t.maxCoeff() >= n) {
      throw std::invalid_argument("HarmonicFill: mesh has a triangle with an index out of range");
    }
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      if (a != b) edges.insert({a, b});
    }
  }
  return edges;
}

/// L = D - W over all points, W_ij = 1 / |p_i - p_j| along edges.
Matrix laplacian(const TriangleMesh& mesh) {
  const auto edges = edgesOf(mesh);
  const auto n = static_cast<Eigen::Index>(mesh.points.size());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(mesh.points.size() + 4 * edges.size());
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, kGround);
  for (const auto& [i, j] : edges) {
    const Eigen::Vector3f edge =
        mesh.points[static_cast<std::size_t>(i)] - mesh.points[static_cast<std::size_t>(j)];
    const double w = 1.0 / std::max(static_cast<double>(edge.norm()), kShortest);
    entries.emplace_back(i, i, w);
    entries.emplace_back(j, j, w);
    entries.emplace_back(i, j, -w);
    entries.emplace_back(j, i, -w);
  }
  Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

HarmonicFill::HarmonicFill(const TriangleMesh& mesh, std::span<const int> driven) {
  const Matrix whole = laplacian(mesh);
  std::vector<int> slot(mesh.points.size(), 0);  // among the free points, -1 for driven ones
  for (const int i : driven) {
    if (i < 0 || static_cast<std::size_t>(i) >= slot.size()) {
      throw std::invalid_argument("HarmonicFill: driven has an index out of range");
    }
    slot[static_cast<std::size_t>(i)] = -1;
  }
  for (std::size_t i = 0; i < slot.size(); ++i) {
    if (slot[i] < 0) continue;
    slot[i] = static_cast<int>(free_.size());
    free_.push_back(static_cast<int>(i));
  }
  if (free_.empty()) return;

  // sum_j w_ij (d_i - d_j) = 0 for every free i: A d_free = B d_driven; P A P' = L L'
  const auto n = static_cast<Eigen::Index>(free_.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (const int point : free_) {
    for (Matrix::InnerIterator e(whole, point); e; ++e) {
      const int row = slot[static_cast<std::size_t>(e.row())];
      if (row >= 0) entries.emplace_back(row, slot[static_cast<std::size_t>(point)], e.value());
    }
  }
  Matrix a(n, n);
  a.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLLT<Matrix> cholesky(a);
  const std::vector<int> natural = free_;
  for (Eigen::Index k = 0; k < n; ++k) {
    free_[static_cast<std::size_t>(cholesky.permutationP().indices()[k])] =
        natural[static_cast<std::size_t>(k)];
  }
  coupling_.start.push_back(0);
  for (const int point : free_) {
    for (Matrix::InnerIterator e(whole, point); e; ++e) {
      if (slot[static_cast<std::size_t>(e.row())] >= 0) continue;
      coupling_.row.push_back(static_cast<int>(e.row()));
      coupling_.value.push_back(static_cast<float>(-e.value()));
    }
    coupling_.start.push_back(static_cast<int>(coupling_.row.size()));
  }
  const Matrix lower = cholesky.matrixL();
  factor_.start.push_back(0);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Matrix::InnerIterator e(lower, j); e; ++e) {
      if (e.row() == j) {
        inverseDiagonal_.push_back(static_cast<float>(1.0 / e.value()));
      } else {
        factor_.row.push_back(static_cast<int>(e.row()));
        factor_.value.push_back(static_cast<float>(e.value()));
      }
    }
    factor_.start.push_back(static_cast<int>(factor_.row.size()));
  }
  x_.resize(free_.size());
}

void HarmonicFill::fill(std::span<Eigen::Vector4f> displacement) {
  const std::size_t n = free_.size();
  const auto entries = [](const Columns& columns, std::size_t j) {
    return std::pair{static_cast<std::size_t>(columns.start[j]),
                     static_cast<std::size_t>(columns.start[j + 1])};
  };
  for (std::size_t j = 0; j < n; ++j) {  // b = B d
    const auto [begin, end] = entries(coupling_, j);
    x_[j].setZero();
    for (std::size_t e = begin; e < end; ++e) {
      x_[j] += coupling_.value[e] * displacement[static_cast<std::size_t>(coupling_.row[e])];
    }
  }
  for (std::size_t j = 0; j < n; ++j) {  // L y = b
    const auto [begin, end] = entries(factor_, j);
    x_[j] *= inverseDiagonal_[j];
    for (std::size_t e = begin; e < end; ++e) {
      x_[static_cast<std::size_t>(factor_.row[e])] -= factor_.value[e] * x_[j];
    }
  }
  for (std::size_t j = n; j-- > 0;) {  // L' x = y
    const auto [begin, end] = entries(factor_, j);
    for (std::size_t e = begin; e < end; ++e) {
      x_[j] -= factor_.value[e] * x_[static_cast<std::size_t>(factor_.row[e])];
    }
    x_[j] *= inverseDiagonal_[j];
    displacement[static_cast<std::size_t>(free_[j])] = x_[j];
  }
}

}  // namespace pleura
