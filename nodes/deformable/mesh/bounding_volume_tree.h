#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// Axis-aligned boxes around triangles, four children a node so that one pass of the vector unit tests them
/// all. Balanced (median splits), hence of bounded depth whatever the triangles. Indices must be in range.
class BoundingVolumeTree {
 public:
  /// Column k holds coordinate k [m] of four boxes.
  using FourCorners = Eigen::Array<double, 4, 3>;
  using FourBounds = Eigen::Array4d;

  BoundingVolumeTree(std::span<const Eigen::Vector3f> points, std::span<const Eigen::Vector3i> triangles);

  /// Boxes around moved points; the shape of the tree stays. Linear; nothing is allocated.
  void refit(std::span<const Eigen::Vector3f> points, std::span<const Eigen::Vector3i> triangles);

  /// Visits triangles nearest box first. bound(low, high) gives the least value in each of four boxes;
  /// visit(triangle) returns the limit, above which boxes are left out from then on.
  template <class Bound, class Visit>
  void visitNearestFirst(double limit, Bound bound, Visit visit) const;

 private:
  static constexpr int leafSize = 2;
  static constexpr int stackSize = 64;  // 3 children wait on each of at most 16 levels: 4^16 > 2^31 triangles

  /// A leaf's triangles order_[first] .. order_[first + count - 1], or, where count is 0, node `first`.
  struct Child {
    int first;
    int count;
  };

  struct Node {
    FourCorners low = FourCorners::Zero();
    FourCorners high = FourCorners::Zero();
    std::array<Child, 4> children;
    int childCount = 0;
  };

  struct Pending {
    double bound;
    Child child;
  };

  Child build(std::span<const Eigen::Vector3f> centroids, int begin, int end);
  int split(std::span<const Eigen::Vector3f> centroids, int begin, int end);

  std::vector<int> order_;   // triangles, a leaf's next to each other
  std::vector<Node> nodes_;  // parents before children
};

template <class Bound, class Visit>
void BoundingVolumeTree::visitNearestFirst(double limit, Bound bound, Visit visit) const {
  std::array<Pending, stackSize> stack;
  int size = 0;
  stack[size++] = {0, {0, 0}};
  while (size > 0) {
    const auto [least, child] = stack[--size];
    if (least > limit) continue;
    for (int i = child.first; i < child.first + child.count; ++i) limit = visit(order_[i]);
    if (child.count > 0) continue;
    const Node& node = nodes_[child.first];
    const FourBounds bounds = bound(node.low, node.high);
    const int base = size;
    for (int k = 0; k < node.childCount; ++k) {
      if (bounds[k] > limit) continue;
      int place = size++;
      for (; place > base && stack[place - 1].bound < bounds[k]; --place) stack[place] = stack[place - 1];
      stack[place] = {bounds[k], node.children[k]};
    }
  }
}

}  // namespace pleura
