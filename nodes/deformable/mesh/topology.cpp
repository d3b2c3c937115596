#include <algorithm>
#include <stdexcept>
#include <string>

#include <pleura/nodes/deformable/mesh/topology.h>

namespace pleura {

namespace {

/// Corner k of the triangle repeats an earlier one.
bool repeats(const Eigen::Vector3i& triangle, int k) {
  return (k > 0 && triangle[k] == triangle[0]) || (k > 1 && triangle[k] == triangle[1]);
}

/// Turns the counts in offsets[1..] into where each row starts.
void accumulate(std::vector<int>& offsets) {
  for (std::size_t i = 1; i < offsets.size(); ++i) offsets[i] += offsets[i - 1];
}

}  // namespace

void requireIndicesInRange(std::size_t pointCount, std::span<const Eigen::Vector3i> triangles) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const int index : triangles[t]) {
      if (index >= 0 && static_cast<std::size_t>(index) < pointCount) continue;
      throw std::invalid_argument("triangles: triangle " + std::to_string(t) + " uses point " +
                                  std::to_string(index) + " of " + std::to_string(pointCount));
    }
  }
}

Adjacency incidentTriangles(std::size_t pointCount, std::span<const Eigen::Vector3i> triangles) {
  requireIndicesInRange(pointCount, triangles);
  Adjacency incident{std::vector<int>(pointCount + 1, 0), {}};
  for (const Eigen::Vector3i& triangle : triangles)
    for (int k = 0; k < 3; ++k)
      if (!repeats(triangle, k)) ++incident.offsets[triangle[k] + 1];
  accumulate(incident.offsets);
  incident.items.resize(incident.offsets.back());
  std::vector<int> next(incident.offsets.begin(), incident.offsets.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (!repeats(triangles[t], k)) incident.items[next[triangles[t][k]]++] = static_cast<int>(t);
  return incident;
}

Adjacency neighbours(std::size_t pointCount, std::span<const Eigen::Vector3i> triangles) {
  const std::vector<Eigen::Vector2i> all = edges(pointCount, triangles);
  Adjacency result{std::vector<int>(pointCount + 1, 0), std::vector<int>(2 * all.size())};
  for (const Eigen::Vector2i& edge : all)
    for (const int end : edge) ++result.offsets[end + 1];
  accumulate(result.offsets);
  std::vector<int> next(result.offsets.begin(), result.offsets.end() - 1);
  for (const Eigen::Vector2i& edge : all) result.items[next[edge[1]]++] = edge[0];
  for (const Eigen::Vector2i& edge : all) result.items[next[edge[0]]++] = edge[1];
  return result;
}

std::vector<Eigen::Vector2i> edges(std::size_t pointCount, std::span<const Eigen::Vector3i> triangles) {
  requireIndicesInRange(pointCount, triangles);
  std::vector<Eigen::Vector2i> all;
  all.reserve(3 * triangles.size());
  for (const Eigen::Vector3i& triangle : triangles) {
    for (int k = 0; k < 3; ++k) {
      const int from = triangle[k], to = triangle[(k + 1) % 3];
      if (from != to) all.emplace_back(std::min(from, to), std::max(from, to));
    }
  }
  std::sort(all.begin(), all.end(), [](const Eigen::Vector2i& a, const Eigen::Vector2i& b) {
    return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1];
  });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace pleura
