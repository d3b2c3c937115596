#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <pleura/nodes/thorax/motion/wall_binding.h>

namespace pleura {
namespace {

// [m] Sliding brings what lay between two ribs under a rib, so what lies nearer than this is lifted on the
// way.
constexpr float kLeastGap = 0.001f;
// [m] Beside the spine the necks of ribs turn: more, as far as no gap grows by more than that.
constexpr float kLeastGapAtJoints = 0.0035f;
constexpr float kMostGrowth = 0.0020f;
constexpr double kLifting = 0.002;  // [m] of sliding that bring half of the lift

using Grid = std::span<const Eigen::Vector4f>;

/// A row of a column as the grid's point above it and the way to the one below.
struct RowPlace {
  std::size_t above;
  float t;

  RowPlace(int column, double row) {
    const double inside = std::clamp(row, 0.0, PleuralWall::kRows - 1.0);
    const int whole = std::min(static_cast<int>(inside), PleuralWall::kRows - 2);
    above = PleuralWall::index(column, whole);
    t = static_cast<float>(inside - whole);
  }
  Eigen::Vector4f of(Grid grid) const { return (1.0f - t) * grid[above] + t * grid[above + 1]; }
};

/// Wall and inward normal between two columns at one v.
struct WallPlace {
  RowPlace a, b;
  float fraction;

  WallPlace(const WallSlide& slide, int column, float columnFraction, double v, double contraction)
      : a(column, slide.row(column, v, contraction)),
        b(PleuralWall::next(column), slide.row(PleuralWall::next(column), v, contraction)),
        fraction(columnFraction) {}
  Eigen::Vector4f of(Grid grid) const { return (1.0f - fraction) * a.of(grid) + fraction * b.of(grid); }
};

/// Whether bone that does not move has a share in carrying a point of the grid or the one below it.
bool stays(const PleuralWall& wall, std::size_t above) {
  const auto carried = [&](std::size_t k) {
    const BodyWeights& w = wall.weights[k];
    return std::accumulate(w.weight.begin(), w.weight.begin() + w.count, 0.0f);
  };
  return std::min(carried(above), carried(above + 1)) < 0.5f;
}

/// v of the place nearest to `point` along the profile at a fraction between two columns.
double nearestV(const PleuralWall& wall, const WallSlide& slide, const WallPoint& at,
                const Eigen::Vector3d& point) {
  constexpr int kSamples = 320;
  constexpr double kLowest = 2.4;
  const auto sample = [&](double v) -> Eigen::Vector3d {
    return WallPlace(slide, at.column, at.fraction, v, 0.0).of(wall.rest).head<3>().cast<double>();
  };
  double nearest = std::numeric_limits<double>::max();
  double found = 0.0;
  Eigen::Vector3d a = sample(0.0);
  for (int k = 1; k <= kSamples; ++k) {
    const Eigen::Vector3d b = sample(kLowest * k / kSamples);
    const double squared = (b - a).squaredNorm();
    const double t = squared > 0.0 ? std::clamp((point - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
    const double distance = (point - a - t * (b - a)).squaredNorm();
    if (distance < nearest) {
      nearest = distance;
      found = kLowest * (k - 1 + t) / kSamples;
    }
    a = b;
  }
  return found;
}

}  // namespace

WallPoint bindToWall(const PleuralWall& wall, const WallSlide& slide, const Eigen::Vector3d& point) {
  const HemithoraxAxis::Coordinates c = wall.axis.coordinates(point);
  const double turn = (c.azimuth + std::numbers::pi) / (2.0 * std::numbers::pi) * PleuralWall::kColumns;
  WallPoint at;
  at.column = static_cast<int>(turn) % PleuralWall::kColumns;
  at.fraction = static_cast<float>(turn - std::floor(turn));
  at.bound = !wall.open(at.column) && !wall.open(PleuralWall::next(at.column));
  if (!at.bound) return at;

  at.v = static_cast<float>(nearestV(wall, slide, at, point));
  const WallPlace place(slide, at.column, at.fraction, at.v, 0.0);
  const Eigen::Vector3d offset = point - place.of(wall.rest).head<3>().cast<double>();
  at.distance = static_cast<float>(offset.norm());
  at.gap = static_cast<float>(offset.dot(place.of(wall.inward).head<3>().cast<double>()));
  at.onSpine = stays(wall, place.a.above) || stays(wall, place.b.above);
  const float least = at.onSpine ? std::min(kLeastGapAtJoints, std::abs(at.gap) + kMostGrowth) : kLeastGap;
  at.lift = std::max(least - at.gap, 0.0f);
  at.rest = followWall(wall, wall.rest, slide, at, 0.0);
  return at;
}

Eigen::Vector4f followWall(const PleuralWall& wall, Grid now, const WallSlide& slide, const WallPoint& point,
                           double contraction) {
  const double v = point.v + advanceMade(contraction) * point.advance;
  const WallPlace place(slide, point.column, point.fraction, v, contraction);
  const double rows = slide.row(point.column, v, contraction) - slide.row(point.column, point.v, 0.0);
  const double slid = rows * wall.spacing[static_cast<std::size_t>(point.column)];
  const double lifted = slid * slid / (slid * slid + kLifting * kLifting);
  const float gap = point.gap + static_cast<float>(lifted) * point.lift;
  return place.of(now) + gap * place.of(wall.inward);
}

}  // namespace pleura
