#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <pleura/nodes/deformable/fem/block_cholesky.h>

namespace pleura {
namespace {

using Panel = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using ConstPanel = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

constexpr double kSmallestPivot = 1e-14;
// Zeros that a panel may hold so that there are fewer panels.
constexpr double kMostZeros = 0.15;
constexpr long kAlwaysMerged = 40;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The rows of L below the diagonal, by columns; a column's parent is the first of them. `adjacent` holds the
// neighbours of each position.
std::vector<std::vector<int>> symbolicFactor(const std::vector<std::vector<int>>& adjacent,
                                             std::size_t mostNumbers) {
  const int n = static_cast<int>(adjacent.size());
  std::vector<std::vector<int>> below(adjacent.size()), children(adjacent.size());
  std::vector<int> mark(adjacent.size(), -1);
  std::size_t numbers = 0;
  for (int j = 0; j < n; ++j) {
    auto& rows = below[j];
    const auto add = [&](int i) {
      if (i > j && mark[i] != j) {
        mark[i] = j;
        rows.push_back(i);
      }
    };
    for (const int i : adjacent[j]) add(i);
    for (const int child : children[j])
      for (const int i : below[child]) add(i);
    numbers += 9 * (rows.size() + 1);
    if (numbers > mostNumbers)
      throw std::invalid_argument("solid: " + std::to_string(n) +
                                  " free nodes are too many: their factor has over " +
                                  std::to_string(mostNumbers) + " numbers");
    std::sort(rows.begin(), rows.end());
    if (!rows.empty()) children[rows.front()].push_back(j);
  }
  return below;
}

// The parent of each column in the elimination tree, -1 for a root (Liu 1990).
std::vector<int> eliminationTree(const std::vector<std::vector<int>>& adjacent) {
  const int n = static_cast<int>(adjacent.size());
  std::vector<int> parent(adjacent.size(), -1), ancestor(adjacent.size(), -1);
  for (int j = 0; j < n; ++j)
    for (int i : adjacent[j])
      while (i < j) {
        const int next = std::exchange(ancestor[i], j);
        if (next < 0) parent[i] = j;
        if (next < 0 || next == j) break;
        i = next;
      }
  return parent;
}

// Children right before their parents, each part of the tree in one piece.
std::vector<int> postorder(const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  std::vector<std::vector<int>> children(parent.size() + 1);
  for (int j = 0; j < n; ++j) children[parent[j] < 0 ? n : parent[j]].push_back(j);
  std::vector<int> order, stack{n};
  while (!stack.empty()) {
    const int j = stack.back();
    stack.pop_back();
    order.push_back(j);
    for (const int child : children[j]) stack.push_back(child);
  }
  std::reverse(order.begin(), order.end());
  order.pop_back();  // n, which stands for no column
  return order;
}

std::vector<std::vector<int>> adjacencyOf(const BlockPattern& pattern, std::span<const int> positionOf,
                                          std::size_t count) {
  std::vector<std::vector<int>> adjacent(count);
  for (int i = 0; i < pattern.rowCount(); ++i)
    for (int slot = pattern.begin[i] + 1; slot < pattern.begin[i + 1]; ++slot) {
      const int p = positionOf[i], q = positionOf[pattern.column[slot]];
      if (p < 0 || q < 0) continue;
      adjacent[p].push_back(q);
      adjacent[q].push_back(p);
    }
  return adjacent;
}

std::vector<int> minimumDegree(const std::vector<std::vector<int>>& adjacent) {
  const int n = static_cast<int>(adjacent.size());
  std::vector<Eigen::Triplet<float>> links;
  for (int i = 0; i < n; ++i) {
    links.emplace_back(i, i, 1.f);
    for (const int j : adjacent[i]) links.emplace_back(i, j, 1.f);
  }
  Eigen::SparseMatrix<float> graph(n, n);
  graph.setFromTriplets(links.begin(), links.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  if (n > 0) Eigen::AMDOrdering<int>()(graph, order);
  return {order.indices().data(), order.indices().data() + n};
}

// The first positions of supernodes. A column joins the one before it when that is its child and the zeros
// this stores are none, or few.
std::vector<int> supernodesOf(const std::vector<std::vector<int>>& below) {
  const int n = static_cast<int>(below.size());
  std::vector<int> firsts;
  std::vector<long> zeros;
  const auto merge = [&](int last) {  // the last two supernodes, of which the second ends before `last`
    const int b = firsts.back(), a = firsts[firsts.size() - 2];
    if (below[b - 1].empty() || below[b - 1].front() != b) return false;
    const long merged = b - a, tail = last - b;
    const long rowsA = static_cast<long>(below[b - 1].size());
    const long rowsB = static_cast<long>(below[last - 1].size());
    const long added = merged * (tail + rowsB - rowsA);
    const long kept = zeros.back() + zeros[zeros.size() - 2] + added;
    const long width = merged + tail;
    const long entries = width * (width + 1) / 2 + width * rowsB;
    const double size = static_cast<double>(entries);
    if (added > 0 && kept > kAlwaysMerged && static_cast<double>(kept) > kMostZeros * size) return false;
    firsts.pop_back();
    zeros.pop_back();
    zeros.back() = kept;
    return true;
  };
  for (int j = 0; j < n; ++j) {
    const bool isChain = j > 0 && !below[j - 1].empty() && below[j - 1].front() == j &&
                         below[j - 1].size() == below[j].size() + 1;
    if (isChain) continue;
    while (firsts.size() > 1 && merge(j)) continue;
    firsts.push_back(j);
    zeros.push_back(0);
  }
  while (firsts.size() > 1 && merge(n)) continue;
  return firsts;
}

}  // namespace

BlockCholesky::BlockCholesky(const BlockPattern& pattern, std::span<const int> unknowns,
                             std::size_t mostNumbers)
    : node_(unknowns.begin(), unknowns.end()) {
  std::vector<int> positionOf(pattern.rowCount(), -1);
  const auto adjacent = [&] {
    for (std::size_t p = 0; p < node_.size(); ++p) positionOf[node_[p]] = static_cast<int>(p);
    return adjacencyOf(pattern, positionOf, node_.size());
  };
  const auto reorder = [&](const std::vector<int>& order) {
    std::vector<int> node;
    node.reserve(order.size());
    for (const int p : order) node.push_back(node_[p]);
    node_ = node;
  };
  reorder(minimumDegree(adjacent()));
  reorder(postorder(eliminationTree(adjacent())));
  const auto below = symbolicFactor(adjacent(), mostNumbers);
  layOut(below, supernodesOf(below));
  placeEntries(pattern, positionOf);
}

void BlockCholesky::layOut(const std::vector<std::vector<int>>& below, std::span<const int> firsts) {
  const int n = static_cast<int>(node_.size());
  std::size_t size = 0;
  int mostRows = 0;
  supernode_.resize(node_.size());
  for (std::size_t k = 0; k < firsts.size(); ++k) {
    const int first = firsts[k], last = k + 1 < firsts.size() ? firsts[k + 1] : n;
    const auto& rows = below[last - 1];
    supernodes_.push_back({first, last, static_cast<int>(rows_.size()), static_cast<int>(rows.size()), size});
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    std::fill(supernode_.begin() + first, supernode_.begin() + last, static_cast<int>(k));
    const std::size_t width = last - first;
    size += 9 * width * (width + rows.size());
    mostRows = std::max(mostRows, 3 * static_cast<int>(rows.size()));
  }
  panels_.resize(size);
  diagonal_.resize(3 * node_.size());
  update_.resize(at(mostRows) * at(mostRows));
  place_.resize(node_.size());
  x_.resize(3L * n);
  gathered_.resize(mostRows);
}

void BlockCholesky::placeEntries(const BlockPattern& pattern, std::span<const int> positionOf) {
  for (int i = 0; i < pattern.rowCount(); ++i)
    for (int slot = pattern.begin[i]; slot < pattern.begin[i + 1]; ++slot) {
      const int p = positionOf[i], q = positionOf[pattern.column[slot]];
      if (p < 0 || q < 0) continue;
      const auto [column, row] = std::minmax(p, q);
      const Supernode& s = supernodes_[supernode_[column]];
      const int width = s.last - s.first;
      int place = row - s.first;
      if (row >= s.last) {
        const auto rows = rows_.begin() + s.rows;
        place = width + static_cast<int>(std::lower_bound(rows, rows + s.rowCount, row) - rows);
      }
      const int stride = 3 * (width + s.rowCount);
      // The slot holds A_ij; wanted is the block of row `row`, column `column`.
      entries_.push_back({p == row ? slot : ~slot, stride,
                          s.panel + at(3 * (column - s.first)) * at(stride) + at(3 * place)});
    }
}

bool BlockCholesky::factorise(const BlockPattern& pattern, const BlockValues& values) {
  std::fill(panels_.begin(), panels_.end(), 0);
  for (const Entry& entry : entries_) {
    Panel block(&panels_[entry.offset], 3, 3, Eigen::OuterStride<>(entry.stride));
    if (entry.slot >= 0)
      block = values[entry.slot];
    else
      block = values[~entry.slot].transpose();
  }
  for (std::size_t p = 0; p < node_.size(); ++p)
    Eigen::Vector3d::Map(&diagonal_[3 * p]) = values[pattern.begin[node_[p]]].diagonal();
  for (const Supernode& s : supernodes_) {
    if (!factorisePanel(s)) return false;
    updateAncestors(s);
  }
  return true;
}

bool BlockCholesky::factorisePanel(const Supernode& s) {
  const int width = 3 * (s.last - s.first), below = 3 * s.rowCount;
  const Eigen::OuterStride<> stride(width + below);
  Panel diagonal(&panels_[s.panel], width, width, stride);
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>> llt(diagonal);
  if (llt.info() != Eigen::Success) return false;
  for (int i = 0; i < width; ++i)
    if (diagonal(i, i) * diagonal(i, i) <= kSmallestPivot * diagonal_[3 * s.first + i]) return false;
  if (below > 0) {
    Panel rows(&panels_[s.panel + width], below, width, stride);
    diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(rows);
  }
  return true;
}

void BlockCholesky::updateAncestors(const Supernode& s) {
  if (s.rowCount == 0) return;
  const int width = 3 * (s.last - s.first), below = 3 * s.rowCount;
  const ConstPanel rows(&panels_[s.panel + width], below, width, Eigen::OuterStride<>(width + below));
  Eigen::Map<Eigen::MatrixXd> update(update_.data(), below, below);
  update.triangularView<Eigen::Lower>() = rows * rows.transpose();
  const int* row = &rows_[s.rows];
  for (int j = 0; j < s.rowCount;) {
    const Supernode& a = supernodes_[supernode_[row[j]]];
    const int widthA = a.last - a.first, stride = 3 * (widthA + a.rowCount);
    for (int p = a.first; p < a.last; ++p) place_[p] = p - a.first;
    for (int i = 0; i < a.rowCount; ++i) place_[rows_[a.rows + i]] = widthA + i;
    for (; j < s.rowCount && row[j] < a.last; ++j)
      for (int c = 0; c < 3; ++c) {
        double* to = &panels_[a.panel + at(3 * (row[j] - a.first) + c) * at(stride)];
        const double* from = &update_[at(3 * j + c) * at(below)];
        for (int i = j; i < s.rowCount; ++i)
          for (int k = 0; k < 3; ++k) to[3 * place_[row[i]] + k] -= from[3 * i + k];
      }
  }
}

void BlockCholesky::solve(const NodeVectors& b, NodeVectors& x) {
  for (std::size_t p = 0; p < node_.size(); ++p)
    x_.segment<3>(static_cast<Eigen::Index>(3 * p)) = b[node_[p]];
  for (const Supernode& s : supernodes_) {  // L y = b
    const int width = 3 * (s.last - s.first), below = 3 * s.rowCount;
    const Eigen::OuterStride<> stride(width + below);
    auto top = x_.segment(3L * s.first, width);
    ConstPanel(&panels_[s.panel], width, width, stride).triangularView<Eigen::Lower>().solveInPlace(top);
    if (below == 0) continue;
    auto sum = gathered_.head(below);
    sum.noalias() = ConstPanel(&panels_[s.panel + width], below, width, stride) * top;
    for (int i = 0; i < s.rowCount; ++i) x_.segment<3>(3L * rows_[s.rows + i]) -= sum.segment<3>(3L * i);
  }
  for (auto s = supernodes_.rbegin(); s != supernodes_.rend(); ++s) {  // L^T x = y
    const int width = 3 * (s->last - s->first), below = 3 * s->rowCount;
    const Eigen::OuterStride<> stride(width + below);
    auto top = x_.segment(3L * s->first, width);
    if (below > 0) {
      auto gathered = gathered_.head(below);
      for (int i = 0; i < s->rowCount; ++i)
        gathered.segment<3>(3L * i) = x_.segment<3>(3L * rows_[s->rows + i]);
      top.noalias() -= ConstPanel(&panels_[s->panel + width], below, width, stride).transpose() * gathered;
    }
    ConstPanel(&panels_[s->panel], width, width, stride)
        .transpose()
        .triangularView<Eigen::Upper>()
        .solveInPlace(top);
  }
  std::fill(x.begin(), x.end(), Eigen::Vector3d::Zero());
  for (std::size_t p = 0; p < node_.size(); ++p)
    x[node_[p]] = x_.segment<3>(static_cast<Eigen::Index>(3 * p));
}

}  // namespace pleura
