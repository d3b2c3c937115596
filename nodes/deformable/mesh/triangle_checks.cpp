#include <algorithm>
#include <tuple>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/triangle_checks.h>

namespace pleura {

namespace {

/// From its smallest point on, a triangle goes to the middle and then to the largest.
bool runsUpwards(const Eigen::Vector3i& triangle) {
  int least = 0;
  triangle.minCoeff(&least);
  return triangle[(least + 1) % 3] < triangle[(least + 2) % 3];
}

using Key = std::tuple<int, int, int, bool, int>;  // points ascending, sense, triangle

std::tuple<int, int, int> pointsOf(const Key& key) {
  return {std::get<0>(key), std::get<1>(key), std::get<2>(key)};
}

}  // namespace

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

Twins twins(std::span<const Eigen::Vector3i> triangles) {
  std::vector<Key> keys;
  for (int t = 0; t < std::ssize(triangles); ++t) {
    Eigen::Vector3i points = triangles[t];
    std::sort(points.begin(), points.end());
    keys.emplace_back(points[0], points[1], points[2], runsUpwards(triangles[t]), t);
  }
  std::sort(keys.begin(), keys.end());
  Twins result{std::vector<bool>(triangles.size(), false), std::vector<int>(triangles.size(), -1)};
  int firstOfSense = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto [a, b, c, sense, t] = keys[i];
    const bool samePoints = i > 0 && std::tuple(a, b, c) == pointsOf(keys[i - 1]);
    if (samePoints && sense == std::get<3>(keys[i - 1])) {
      result.repeated[t] = true;
      continue;
    }
    if (samePoints) {
      result.opposite[firstOfSense] = t;
      result.opposite[t] = firstOfSense;
    }
    firstOfSense = t;
  }
  return result;
}

}  // namespace pleura
