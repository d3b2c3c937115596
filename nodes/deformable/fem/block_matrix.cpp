#include <algorithm>

#include <pleura/nodes/deformable/fem/block_matrix.h>

namespace pleura {

int BlockPattern::slot(int i, int j) const {
  const auto [row, col] = std::minmax(i, j);
  const auto from = column.begin() + begin[row];
  const auto to = column.begin() + begin[static_cast<std::size_t>(row) + 1];
  const int slot = static_cast<int>(std::lower_bound(from, to, col) - column.begin());
  return i <= j ? slot : ~slot;
}

BlockPattern makeBlockPattern(int nodeCount, std::span<const int> begin, std::span<const int> node) {
  std::vector<std::vector<int>> rows(static_cast<std::size_t>(nodeCount));
  for (int i = 0; i < nodeCount; ++i) rows[i].push_back(i);
  for (std::size_t g = 0; g + 1 < begin.size(); ++g) {
    const auto group =
        node.subspan(static_cast<std::size_t>(begin[g]), static_cast<std::size_t>(begin[g + 1] - begin[g]));
    for (const int i : group)
      for (const int j : group)
        if (i < j) rows[i].push_back(j);
  }
  BlockPattern pattern;
  pattern.begin.push_back(0);
  for (auto& row : rows) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    pattern.column.insert(pattern.column.end(), row.begin(), row.end());
    pattern.begin.push_back(pattern.slotCount());
  }
  return pattern;
}

void multiply(const BlockPattern& pattern, const BlockValues& values, const NodeVectors& x, NodeVectors& y) {
  std::fill(y.begin(), y.end(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i + 1 < pattern.begin.size(); ++i) {
    auto slot = static_cast<std::size_t>(pattern.begin[i]);
    const auto end = static_cast<std::size_t>(pattern.begin[i + 1]);
    // a copy: what is written to y is not part of x, but the compiler can't know
    const Eigen::Vector3d xi = x[i];  // NOLINT(performance-unnecessary-copy-initialization)
    Eigen::Vector3d yi = y[i] + values[slot] * xi;
    for (++slot; slot < end; ++slot) {
      const auto j = static_cast<std::size_t>(pattern.column[slot]);
      yi += values[slot] * x[j];
      y[j] += values[slot].transpose() * xi;
    }
    y[i] = yi;
  }
}

}  // namespace pleura
