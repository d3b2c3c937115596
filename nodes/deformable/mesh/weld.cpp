#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/weld.h>

namespace pleura {

namespace {

using Eigen::Vector3d;
using Cell = std::array<double, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const double x : cell) {  // splitmix64's finaliser
      hash = (hash ^ std::bit_cast<std::uint64_t>(x)) + 0x9e3779b97f4a7c15u;
      hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
      hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
      hash ^= hash >> 31;
    }
    return hash;
  }
};

/// Points that stand for others, in cells as wide as the distance: a cell holds few of them, however dense
/// the points.
class Representatives {
 public:
  Representatives(std::span<const Eigen::Vector3f> points, double distance)
      : points_(points), distance_(distance) {}

  /// The representative within the distance of the point, or the point itself, which is one from now on.
  int findOrAdd(int point) {
    const Vector3d p = points_[point].cast<double>();
    const int reach = distance_ > 0 ? 1 : 0;
    for (int x = -reach; x <= reach; ++x)
      for (int y = -reach; y <= reach; ++y)
        for (int z = -reach; z <= reach; ++z)
          if (const int found = findIn(cellOf(p, {x, y, z}), p); found >= 0) return found;
    cells_[cellOf(p, {0, 0, 0})].push_back(point);
    return point;
  }

 private:
  Cell cellOf(const Vector3d& p, const std::array<int, 3>& offset) const {
    Cell cell;
    for (int k = 0; k < 3; ++k) {
      const double coordinate = distance_ > 0 ? std::floor(p[k] / distance_) : p[k];
      cell[k] = coordinate + offset[k] + 0.0;  // + 0.0: minus zero is the same place
    }
    return cell;
  }

  int findIn(const Cell& cell, const Vector3d& p) const {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return -1;
    for (const int candidate : found->second)
      if ((points_[candidate].cast<double>() - p).norm() <= distance_) return candidate;
    return -1;
  }

  std::span<const Eigen::Vector3f> points_;
  double distance_;
  std::unordered_map<Cell, std::vector<int>, CellHash> cells_;
};

}  // namespace

std::vector<int> weldedPoints(std::span<const Eigen::Vector3f> points, double distance) {
  constexpr double least = 1e-12;
  if (!std::isfinite(distance) || distance < 0 || (distance > 0 && distance < least))
    throw std::invalid_argument("weldDistance: must be 0 or from 1e-12 m");
  Representatives representatives(points, distance);
  std::vector<int> result(points.size());
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    result[i] = isFinite(points[i]) ? representatives.findOrAdd(i) : i;
  return result;
}

}  // namespace pleura
