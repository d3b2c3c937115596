#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <pleura/nodes/lung/planar/concentric_mesh.h>
#include <pleura/nodes/lung/planar/hemithorax.h>

namespace pleura::planar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3i;

constexpr int kLandmarks = 13;
constexpr int kCardiophrenic = 2, kCostophrenic = 6;  // landmarks
constexpr int kSamples = 64;                          // of the curve between two landmarks

void require(bool isRight, const char* what) {
  if (!isRight) throw std::invalid_argument(std::string("hemithorax: ") + what);
}

void check(const HemithoraxShape& shape) {
  for (const double length : {shape.width, shape.height, shape.domeHeight, shape.midlineToHilum,
                              shape.naturalScale, shape.film, shape.woundHeight, shape.woundLength})
    require(std::isfinite(length), "every length must be finite");
  require(shape.width > 0, "width must be positive");
  require(shape.height > 0, "height must be positive");
  require(shape.domeHeight > 0 && shape.domeHeight <= shape.height / 3,
          "domeHeight must be positive and at most a third of height");
  require(shape.midlineToHilum >= 0, "midlineToHilum must not be negative");
  require(shape.naturalScale >= 0.3 && shape.naturalScale < 1, "naturalScale must be in [0.3, 1)");
  require(shape.film > 0 && shape.film < 0.05 * shape.width, "film must be positive and thin");
  require(shape.woundLength >= 0 && shape.woundLength < shape.height / 2,
          "woundLength must be in [0, height / 2)");
  require(shape.rings >= 3 && shape.rings <= 48, "rings must be in [3, 48]");
}

/// Down the mediastinum from the hilum, over the diaphragm to the recess, up the lateral wall to the apex and
/// back: x from the hilum outwards, y up.
std::array<Vector2d, kLandmarks> landmarks(const HemithoraxShape& shape) {
  const double w = shape.width;
  const double h = shape.height;
  const double base = -0.56 * h;
  const double dome = shape.domeHeight;
  return {Vector2d(0, 0),
          {0.02 * w, -0.19 * h},
          {0.09 * w, base + 0.58 * dome},
          {0.24 * w, base + 0.88 * dome},
          {0.46 * w, base + dome},
          {0.73 * w, base + 0.58 * dome},
          {0.955 * w, base},
          {1.0 * w, -0.28 * h},
          {0.97 * w, -0.02 * h},
          {0.86 * w, 0.22 * h},
          {0.64 * w, 0.40 * h},
          {0.36 * w, 0.455 * h},
          {0.12 * w, 0.29 * h}};
}

/// A closed Catmull-Rom curve through the landmarks, and the length of it before each sample.
struct Curve {
  std::vector<Vector2d> points;
  std::vector<double> length{0};

  explicit Curve(const std::array<Vector2d, kLandmarks>& marks) {
    for (int i = 0; i < kLandmarks; ++i) {
      const auto mark = [&](int k) {
        return marks[static_cast<std::size_t>((i + k + kLandmarks) % kLandmarks)];
      };
      const Vector2d a = (mark(1) - mark(-1)) / 2;
      const Vector2d b = (mark(2) - mark(0)) / 2;
      for (int j = 0; j < kSamples; ++j) {
        const double s = static_cast<double>(j) / kSamples;
        const double s2 = s * s;
        const double s3 = s2 * s;
        points.emplace_back((2 * s3 - 3 * s2 + 1) * mark(0) + (3 * s2 - 2 * s3) * mark(1) +
                            (s3 - 2 * s2 + s) * a + (s3 - s2) * b);
      }
    }
    points.push_back(points.front());
    for (std::size_t k = 1; k < points.size(); ++k)
      length.push_back(length.back() + (points[k] - points[k - 1]).norm());
  }

  double lengthAt(int landmark) const { return length[static_cast<std::size_t>(landmark) * kSamples]; }

  Vector2d at(double along) const {
    std::size_t k = 1;
    while (k + 1 < length.size() && length[k] < along) ++k;
    const double part = (along - length[k - 1]) / (length[k] - length[k - 1]);
    return points[k - 1] + part * (points[k] - points[k - 1]);
  }
};

double smoothStep(double s) {
  s = std::fmin(std::fmax(s, 0.0), 1.0);
  return s * s * (3 - 2 * s);
}

/// The dome sinks most in its middle, its ends are fast to the ribs. The wall goes out as ribs do that turn
/// about the spine: more the farther from it, and more the lower.
ChestOutline makeWall(const HemithoraxShape& shape) {
  const Curve curve(landmarks(shape));
  const auto count = 12 * static_cast<std::size_t>(shape.rings);
  const double from = curve.lengthAt(kCardiophrenic);
  const double to = curve.lengthAt(kCostophrenic);
  ChestOutline wall;
  for (std::size_t k = 0; k < count; ++k) {
    const double along = curve.length.back() * static_cast<double>(k) / static_cast<double>(count);
    const Vector2d p = curve.at(along);
    const double part = (along - from) / (to - from);
    const bool isDiaphragm = part > 0 && part < 1;
    const double down = isDiaphragm ? std::sin(std::numbers::pi * part) : 0;
    const double out = p.x() / shape.width;
    wall.rest.push_back(p);
    wall.diaphragm.emplace_back(0, -down);
    wall.chestWall.emplace_back(out * out * smoothStep((0.46 * shape.height - p.y()) / (0.7 * shape.height)),
                                0);
  }
  return wall;
}

void openWound(const HemithoraxShape& shape, ChestOutline& wall) {
  const int count = static_cast<int>(wall.rest.size());
  const auto point = [&](int k) { return wall.rest[static_cast<std::size_t>((k + count) % count)]; };
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < count; ++k) {
    const double off = std::abs(point(k).y() - shape.woundHeight);
    if (point(k).x() < shape.width / 2 || off >= least) continue;
    least = off;
    nearest = k;
  }
  wall.woundBegin = wall.woundEnd = nearest;
  for (double length = 0; length < shape.woundLength && wall.woundBegin > 1 && wall.woundEnd < count - 1;) {
    length += (point(wall.woundBegin) - point(wall.woundBegin - 1)).norm();
    --wall.woundBegin;
    if (length >= shape.woundLength) break;
    length += (point(wall.woundEnd + 1) - point(wall.woundEnd)).norm();
    ++wall.woundEnd;
  }
}

/// The wall moved inwards by somewhat more than the film, every other point of it, drawn together about the
/// hilum.
std::vector<Vector2d> naturalOutline(const HemithoraxShape& shape, const ChestOutline& wall) {
  const std::size_t count = wall.rest.size();
  std::vector<Vector2d> outline;
  for (std::size_t k = 0; k < count; k += 2) {
    const Vector2d along = wall.rest[(k + 1) % count] - wall.rest[(k + count - 1) % count];
    outline.emplace_back(wall.rest[k] + 1.5 * shape.film * Vector2d(-along.y(), along.x()).normalized());
  }
  const Vector2d hilum = outline.front();
  for (Vector2d& p : outline) p = hilum + shape.naturalScale * (p - hilum);
  return outline;
}

std::vector<Vector3i> makeStrip(int lungCount) {
  const int wallCount = 2 * lungCount;
  std::vector<Vector3i> strip;
  for (int i = 0; i < lungCount; ++i) {
    const int next = (i + 1) % lungCount;
    const auto wall = [&](int k) { return lungCount + (2 * i + k) % wallCount; };
    strip.emplace_back(i, wall(0), wall(1));
    strip.emplace_back(i, wall(1), next);
    strip.emplace_back(next, wall(1), wall(2));
  }
  return strip;
}

void mirror(Hemithorax& half) {
  const auto flip = [](std::vector<Vector2d>& points) {
    for (Vector2d& p : points) p.x() = -p.x();
  };
  flip(half.wall.rest);
  flip(half.wall.diaphragm);
  flip(half.wall.chestWall);
  flip(half.lung.points);
  for (auto* triangles : {&half.lung.triangles, &half.strip})
    for (Vector3i& t : *triangles) std::swap(t[1], t[2]);
  half.wall.orientation = -1;
}

}  // namespace

Hemithorax makeHemithorax(const HemithoraxShape& shape) {
  check(shape);
  Hemithorax half;
  half.wall = makeWall(shape);
  openWound(shape, half.wall);
  half.lung = concentricMesh(naturalOutline(shape, half.wall));
  half.lung.heldCount = (half.lung.outlineCount + 18) / 36;
  half.strip = makeStrip(half.lung.outlineCount);
  for (auto* points : {&half.wall.rest, &half.lung.points})
    for (Vector2d& p : *points) p.x() += shape.midlineToHilum;
  if (shape.isMirrored) mirror(half);
  return half;
}

std::vector<int> Hemithorax::wallLine(bool isWounded) const {
  const int count = static_cast<int>(wall.rest.size());
  const int first = isWounded ? wall.woundEnd : 0;
  const int length = isWounded ? count - (wall.woundEnd - wall.woundBegin) : count;
  std::vector<int> line;
  for (int k = 0; k <= length; ++k) line.push_back((first + k) % count);
  return line;
}

}  // namespace pleura::planar
