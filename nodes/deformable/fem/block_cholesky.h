#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/fem/block_matrix.h>

namespace pleura {

/// 4 GiB of doubles: about those of a lattice of 40,000 cells.
inline constexpr std::size_t kMostFactorNumbers = std::size_t{1} << 29;

/// A = L L^T of a sparse symmetric matrix of 3 x 3 blocks, for one pattern and many values. Columns of L with
/// the same rows below them are kept as one dense panel (a supernode: Ng and Peyton 1993), so that a solve
/// streams through memory twice and does little else. Analysed at construction; solve() allocates nothing.
class BlockCholesky {
 public:
  BlockCholesky() = default;
  /// Of the rows and columns of the nodes in `unknowns`, in an order that keeps the fill low (approximate
  /// minimum degree of the graph of nodes: Amestoy, Davis and Duff 1996). Throws std::invalid_argument when L
  /// would have more than `mostNumbers`, before it takes memory for them.
  BlockCholesky(const BlockPattern& pattern, std::span<const int> unknowns,
                std::size_t mostNumbers = kMostFactorNumbers);

  /// Factorises. False when a pivot is below 1e-14 of its diagonal: the matrix is singular, or not positive,
  /// and there is nothing to solve with.
  bool factorise(const BlockPattern& pattern, const BlockValues& values);

  /// x := A^-1 b at the unknowns, 0 at the other nodes. b and x may be the same. After factorise() said true.
  void solve(const NodeVectors& b, NodeVectors& x);

  std::size_t factorSize() const { return panels_.size(); }  ///< numbers kept

 private:
  struct Supernode {
    int first, last;    // positions [first, last)
    int rows;           // where its rows below begin in rows_
    int rowCount;       // in nodes
    std::size_t panel;  // where its panel begins: columns of height 3 (last - first + rowCount)
  };
  /// Where a block of A goes: into the panels, at `offset` of a column-major array of height `stride`.
  struct Entry {
    int slot;  // of the pattern; ~slot: its transpose
    int stride;
    std::size_t offset;
  };

  void layOut(const std::vector<std::vector<int>>& below, std::span<const int> firsts);
  void placeEntries(const BlockPattern& pattern, std::span<const int> positionOf);
  bool factorisePanel(const Supernode& s);
  void updateAncestors(const Supernode& s);

  std::vector<int> node_;       // [position] the unknown there
  std::vector<int> supernode_;  // [position]
  std::vector<Supernode> supernodes_;
  std::vector<int> rows_;  // positions
  std::vector<Entry> entries_;
  std::vector<double> panels_;
  std::vector<double> diagonal_;  // of A, [3 position + i]
  std::vector<double> update_;    // work space
  std::vector<int> place_;        // work space, [position]
  Eigen::VectorXd x_;             // work space, by position
  Eigen::VectorXd gathered_;      // work space
};

}  // namespace pleura
