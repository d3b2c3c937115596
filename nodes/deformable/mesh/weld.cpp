#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <utility>

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

/// Points that stand for others, in cells four times as wide as the distance: a ball of it reaches into two
/// along each axis at most, most often into one, and a cell holds few of them, however dense the points.
class Representatives {
 public:
  Representatives(std::span<const Eigen::Vector3f> points, double distance)
      : points_(points), distance_(distance), next_(points.size(), -1) {
    last_.reserve(points.size());
  }

  /// The first representative within the distance of the point, or the point itself, which is one from now
  /// on.
  int findOrAdd(int point) {
    const Vector3d p = points_[point].cast<double>();
    const Cell low = cellOf(p.array() - distance_), high = cellOf(p.array() + distance_);
    int first = point;
    for (int corner = 0; corner < 8; ++corner) {
      Cell cell;
      bool isRepeated = false;
      for (int k = 0; k < 3; ++k) {
        const bool isHigh = (corner >> k & 1) != 0;
        cell[k] = isHigh ? high[k] : low[k];
        isRepeated = isRepeated || (isHigh && low[k] == high[k]);
      }
      if (!isRepeated) first = firstIn(cell, p, first);
    }
    if (first == point) {
      const auto [last, isNew] = last_.try_emplace(cellOf(p), point);
      if (!isNew) next_[point] = std::exchange(last->second, point);
    }
    return first;
  }

 private:
  Cell cellOf(const Eigen::Array3d& p) const {
    Cell cell;
    for (int k = 0; k < 3; ++k)
      cell[k] =
          (distance_ > 0 ? std::floor(p[k] / (4 * distance_)) : p[k]) + 0.0;  // + 0.0: -0 is the same place
    return cell;
  }

  int firstIn(const Cell& cell, const Vector3d& p, int first) const {
    const auto found = last_.find(cell);
    if (found == last_.end()) return first;
    for (int candidate = found->second; candidate >= 0; candidate = next_[candidate])
      if (candidate < first && (points_[candidate].cast<double>() - p).norm() <= distance_) first = candidate;
    return first;
  }

  std::span<const Eigen::Vector3f> points_;
  double distance_;
  std::unordered_map<Cell, int, CellHash> last_;  // representative in a cell
  std::vector<int> next_;                         // representative in the same cell as this one; -1: none
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
