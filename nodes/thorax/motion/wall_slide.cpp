#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <pleura/nodes/thorax/motion/wall_binding.h>
#include <pleura/nodes/thorax/motion/wall_slide.h>

namespace pleura {
namespace {

constexpr double kNearWall = 0.015;      // [m] points of a ring farther from the wall are not on it
constexpr double kZoneKept = 0.3;        // of the zone of apposition, at inflation 1
constexpr double kShortestZone = 0.004;  // [m]
constexpr int kSmoothings = 4;
constexpr std::size_t n = PleuralWall::kColumns;

using Columns = std::vector<double>;

/// Sums over a ring's points near each column: distance from the cupola times share [m], and shares.
void gather(const PleuralWall& wall, std::span<const Eigen::Vector3d> ring, Columns& sum, Columns& share) {
  constexpr double kLastRow = PleuralWall::kRows - 1.0;
  const WallSlide whole{Columns(n, kLastRow), Columns(n, kLastRow),
                        Columns(n, 0.0)};  // v = 1 is the last row
  for (const Eigen::Vector3d& p : ring) {
    const WallPoint point = bindToWall(wall, whole, p);
    if (!point.bound || point.distance > kNearWall) continue;
    const double row = std::min<double>(point.v, 1.0) * kLastRow;
    const auto add = [&](int column, double w) {
      const auto c = static_cast<std::size_t>(column);
      sum[c] += w * row * wall.spacing[c];
      share[c] += w;
    };
    add(point.column, 1.0 - point.fraction);
    add(PleuralWall::next(point.column), point.fraction);
  }
}

/// Steps from column c to the nearest that has a share, going round in the given direction; n when none has.
std::size_t stepsToShare(const Columns& share, std::size_t c, std::size_t direction) {
  constexpr double kEnough = 0.3;
  std::size_t steps = 0;
  while (steps < n && share[(c + steps * direction) % n] < kEnough) ++steps;
  return steps;
}

/// Distance of a ring from the cupola on every column [m]: means near each, gaps filled from both sides,
/// smoothed.
Columns ringBelowCupola(const PleuralWall& wall, std::span<const Eigen::Vector3d> ring) {
  Columns sum(n, 0.0);
  Columns share(n, 0.0);
  gather(wall, ring, sum, share);
  Columns below(n, 0.0);
  for (std::size_t c = 0; c < n; ++c) {
    const std::size_t ahead = stepsToShare(share, c, 1);
    const std::size_t behind = stepsToShare(share, c, n - 1);
    if (ahead == n) throw std::invalid_argument("slideOnWall: no point of the diaphragm lies near the wall");
    const std::size_t a = (c + ahead) % n;
    const std::size_t b = (c + behind * (n - 1)) % n;
    const double t = ahead > 0 ? static_cast<double>(ahead) / static_cast<double>(ahead + behind) : 0.0;
    below[c] = (1.0 - t) * sum[a] / share[a] + t * sum[b] / share[b];
  }
  for (int pass = 0; pass < kSmoothings; ++pass) {
    const Columns before = below;
    for (std::size_t c = 0; c < n; ++c) {
      below[c] = 0.25 * before[(c + n - 1) % n] + 0.5 * before[c] + 0.25 * before[(c + 1) % n];
    }
  }
  return below;
}

}  // namespace

WallSlide slideOnWall(const PleuralWall& wall, std::span<const Eigen::Vector3d> fold,
                      std::span<const Eigen::Vector3d> rim, double drop) {
  if (!std::isfinite(drop)) throw std::invalid_argument("slideOnWall: drop must be finite");
  WallSlide slide{ringBelowCupola(wall, fold), ringBelowCupola(wall, rim), Columns(n, 0.0)};
  for (std::size_t c = 0; c < n; ++c) {
    const double zone = std::max(slide.rim[c] - slide.fold[c], kShortestZone);
    const double rowsPerMetre = wall.spacing[c] > 0.0 ? 1.0 / wall.spacing[c] : 0.0;
    slide.rim[c] = (slide.fold[c] + zone) * rowsPerMetre;
    slide.fold[c] *= rowsPerMetre;
    slide.drop[c] = std::min(drop, (1.0 - kZoneKept) * zone) * rowsPerMetre;
  }
  return slide;
}

}  // namespace pleura
