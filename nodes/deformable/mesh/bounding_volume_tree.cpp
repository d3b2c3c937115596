#include <algorithm>
#include <numeric>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/mesh/bounding_volume_tree.h>

namespace pleura {

using Eigen::Vector3f;
using Eigen::Vector3i;

BoundingVolumeTree::BoundingVolumeTree(std::span<const Vector3f> points, std::span<const Vector3i> triangles)
    : order_(triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  std::vector<Vector3f> centroids;
  centroids.reserve(triangles.size());
  for (const Vector3i& triangle : triangles)
    centroids.push_back(points[triangle[0]] / 3 + points[triangle[1]] / 3 + points[triangle[2]] / 3);
  build(centroids, 0, static_cast<int>(order_.size()));
  refit(points, triangles);
}

/// Divides the range at the median of its longest axis; returns where the second half begins.
int BoundingVolumeTree::split(std::span<const Vector3f> centroids, int begin, int end) {
  Eigen::AlignedBox3d box;
  for (int i = begin; i < end; ++i) box.extend(centroids[order_[i]].cast<double>());
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&centroids, axis](int s, int t) {
                     return std::pair(centroids[s][axis], s) < std::pair(centroids[t][axis], t);
                   });
  return middle;
}

BoundingVolumeTree::Child BoundingVolumeTree::build(std::span<const Vector3f> centroids, int begin, int end) {
  if (end - begin <= leafSize && !nodes_.empty()) return {begin, end - begin};
  const int self = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  const int middle = split(centroids, begin, end);
  for (const auto& [from, to] : {std::pair(begin, middle), std::pair(middle, end)}) {
    if (from == to) continue;
    const int half = to - from > leafSize ? split(centroids, from, to) : to;
    for (const auto& [first, last] : {std::pair(from, half), std::pair(half, to)}) {
      if (first == last) continue;
      const Child child = build(centroids, first, last);
      nodes_[self].children[nodes_[self].childCount++] = child;
    }
  }
  return {self, 0};
}

void BoundingVolumeTree::refit(std::span<const Vector3f> points, std::span<const Vector3i> triangles) {
  for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
    for (int k = 0; k < node->childCount; ++k) {
      const auto [first, count] = node->children[k];
      if (count == 0) {
        const Node& inner = nodes_[first];
        node->low.row(k) = inner.low.topRows(inner.childCount).colwise().minCoeff();
        node->high.row(k) = inner.high.topRows(inner.childCount).colwise().maxCoeff();
        continue;
      }
      Eigen::AlignedBox3f box;
      for (int i = first; i < first + count; ++i)
        for (const int corner : triangles[order_[i]]) box.extend(points[corner]);
      node->low.row(k) = box.min().transpose().array().cast<double>();
      node->high.row(k) = box.max().transpose().array().cast<double>();
    }
  }
}

}  // namespace pleura
