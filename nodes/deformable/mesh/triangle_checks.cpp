#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/triangle_checks.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace pleura {

bool isInRange(const Eigen::Vector3i& triangle, std::size_t pointCount) {
  return std::all_of(triangle.begin(), triangle.end(), [pointCount](int index) {
    return index >= 0 && static_cast<std::size_t>(index) < pointCount;
  });
}

bool repeatsPoint(const Eigen::Vector3i& triangle) {
  return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}

bool isFinite(const Eigen::Vector3i& triangle, std::span<const Eigen::Vector3f> points) {
  return std::all_of(triangle.begin(), triangle.end(),
                     [points](int index) { return isFinite(points[index]); });
}

bool isFlat(const Eigen::Vector3i& triangle, std::span<const Eigen::Vector3f> points) {
  const Eigen::Vector3d a = points[triangle[0]].cast<double>();
  const Eigen::Vector3d ab = points[triangle[1]].cast<double>() - a;
  const Eigen::Vector3d ac = points[triangle[2]].cast<double>() - a;
  return ab.cross(ac).squaredNorm() <= 1e-12 * ab.squaredNorm() * ac.squaredNorm();
}

std::vector<bool> duplicates(std::span<const Eigen::Vector3i> triangles) {
  std::vector<Eigen::Vector3i> sorted(triangles.begin(), triangles.end());
  for (Eigen::Vector3i& triangle : sorted) std::sort(triangle.begin(), triangle.end());
  const auto less = [&sorted](int s, int t) {
    return std::lexicographical_compare(sorted[s].begin(), sorted[s].end(), sorted[t].begin(),
                                        sorted[t].end());
  };
  std::vector<int> order(triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), less);
  std::vector<bool> result(triangles.size(), false);
  for (std::size_t i = 1; i < order.size(); ++i) result[order[i]] = sorted[order[i]] == sorted[order[i - 1]];
  return result;
}

}  // namespace pleura
