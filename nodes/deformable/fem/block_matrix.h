#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// One vector a node, and the same as a column of numbers.
using NodeVectors = std::vector<Eigen::Vector3d>;
inline Eigen::Map<Eigen::VectorXd> flat(NodeVectors& x) {
  return {x.empty() ? nullptr : x.front().data(), 3 * static_cast<Eigen::Index>(x.size())};
}
inline Eigen::Map<const Eigen::VectorXd> flat(const NodeVectors& x) {
  return {x.empty() ? nullptr : x.front().data(), 3 * static_cast<Eigen::Index>(x.size())};
}

/// Which nodes of a body are coupled: the upper triangle by rows. Row i holds column[begin[i]] = i and then
/// those beyond the diagonal, ascending.
struct BlockPattern {
  std::vector<int> begin;
  std::vector<int> column;

  int rowCount() const { return static_cast<int>(begin.size()) - 1; }
  int slotCount() const { return static_cast<int>(column.size()); }
  /// Where block (i, j) is: its slot when i <= j, ~slot when the transpose is stored. It must be there.
  int slot(int i, int j) const;
};

/// Couples all nodes of a group with each other: group g has node[begin[g]] to node[begin[g + 1] - 1].
BlockPattern makeBlockPattern(int nodeCount, std::span<const int> begin, std::span<const int> node);

/// A symmetric matrix of 3 x 3 blocks, its upper triangle in the pattern's order.
using BlockValues = std::vector<Eigen::Matrix3d>;

/// Adds a block where BlockPattern::slot says.
inline void addBlock(BlockValues& values, int slot, const Eigen::Matrix3d& block) {
  if (slot >= 0)
    values[slot] += block;
  else
    values[~slot] += block.transpose();
}

/// y = A x.
void multiply(const BlockPattern& pattern, const BlockValues& values, const NodeVectors& x, NodeVectors& y);

}  // namespace pleura
