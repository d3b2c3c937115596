#include <pleura/nodes/thorax/motion/wall_binding.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pleura {
namespace {

constexpr int kSamples = 320;   // of v in [0, kLowest] when a point is bound
constexpr double kLowest = 2.4;

int nextColumn(int column) { return (column + 1) % PleuralWall::kColumns; }

/// Linear interpolation of a field of the grid between two rows of a column.
Eigen::Vector3d alongColumn(std::span<const Eigen::Vector3d> field, int column, double row) {
  const double inside = std::clamp(row, 0.0, PleuralWall::kRows - 1.001);
  const int i = static_cast<int>(inside);
  const std::size_t k = PleuralWall::index(column, i);
  const double t = inside - i;
  return (1.0 - t) * field[k] + t * field[k + 1];
}

Eigen::Vector3d onGrid(std::span<const Eigen::Vector3d> field, const WallSlide& slide, const WallPoint& point,
                       double inflation) {
  const int other = nextColumn(point.column);
  return (1.0 - point.fraction) *
             alongColumn(field, point.column, slide.row(point.column, point.v, inflation)) +
         point.fraction * alongColumn(field, other, slide.row(other, point.v, inflation));
}

}  // namespace

WallPoint bindToWall(const PleuralWall& wall, const WallSlide& slide, const Eigen::Vector3d& point) {
  const HemithoraxAxis::Coordinates c = wall.axis.coordinates(point);
  const double turn = (c.azimuth + std::numbers::pi) / (2.0 * std::numbers::pi) * PleuralWall::kColumns;
  WallPoint found;
  found.column = static_cast<int>(turn) % PleuralWall::kColumns;
  found.fraction = turn - std::floor(turn);
  found.bound = wall.spacing[static_cast<std::size_t>(found.column)] > 0.0 &&
                wall.spacing[static_cast<std::size_t>(nextColumn(found.column))] > 0.0;
  if (!found.bound) return found;

  double nearest = std::numeric_limits<double>::max();
  WallPoint sample = found;
  Eigen::Vector3d a = onGrid(wall.rest, slide, sample, 0.0);
  for (int k = 1; k <= kSamples; ++k) {
    sample.v = kLowest * k / kSamples;
    const Eigen::Vector3d b = onGrid(wall.rest, slide, sample, 0.0);
    const double squared = (b - a).squaredNorm();
    const double t = squared > 0.0 ? std::clamp((point - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
    const double distance = (point - a - t * (b - a)).squaredNorm();
    if (distance < nearest) {
      nearest = distance;
      found.v = kLowest * (k - 1 + t) / kSamples;
    }
    a = b;
  }
  const Eigen::Vector3d foot = onGrid(wall.rest, slide, found, 0.0);
  const Eigen::Vector3d inward = onGrid(wall.inward, slide, found, 0.0);
  found.gap = (point - foot).dot(inward);
  found.remainder = point - foot - found.gap * inward;
  return found;
}

Eigen::Vector3d followWall(const PleuralWall& wall, std::span<const Eigen::Vector3d> now, const WallSlide& slide,
                           const WallPoint& point, double inflation) {
  return onGrid(now, slide, point, inflation) + point.gap * onGrid(wall.inward, slide, point, inflation) +
         point.remainder;
}

}  // namespace pleura
