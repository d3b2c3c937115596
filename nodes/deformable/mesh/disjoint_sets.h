#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace pleura {

/// Sets that grow together (Tarjan 1975, path halving); the smallest member stands for its set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }

  void unite(int a, int b) {
    const int first = find(a), second = find(b);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace pleura
