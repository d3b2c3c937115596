#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <pleura/nodes/lung/planar/hemithorax.h>
#include <pleura/nodes/lung/planar/polygon.h>

namespace pleura::planar {
namespace {

using Eigen::Vector2d;

double areaOf(const std::vector<Vector2d>& points, const Eigen::Vector3i& t) {
  const auto p = [&](int k) { return points[static_cast<std::size_t>(t[k])]; };
  return cross(p(1) - p(0), p(2) - p(0)) / 2;
}

TEST(Hemithorax, TrianglesFillTheLungAndTheStripTheRest) {
  for (const int rings : {3, 5, 6, 12})
    for (const bool isMirrored : {false, true}) {
      const Hemithorax half = makeHemithorax({.rings = rings, .isMirrored = isMirrored});
      EXPECT_EQ(half.lung.triangles.size(), static_cast<std::size_t>(6 * rings * rings));
      EXPECT_EQ(half.lung.outlineCount, 6 * rings);
      std::vector<Vector2d> outline = half.lung.points;
      outline.resize(static_cast<std::size_t>(half.lung.outlineCount));
      double sum = 0;
      for (const auto& t : half.lung.triangles) {
        EXPECT_GT(areaOf(half.lung.points, t), 0);
        sum += areaOf(half.lung.points, t);
      }
      const double lung = half.wall.orientation * area(outline);
      EXPECT_NEAR(sum, lung, 1e-15);
      std::vector<Vector2d> both = outline;
      both.insert(both.end(), half.wall.rest.begin(), half.wall.rest.end());
      double strip = 0;
      for (const auto& t : half.strip) {
        EXPECT_GT(areaOf(both, t), 0);
        strip += areaOf(both, t);
      }
      EXPECT_NEAR(strip, half.wall.orientation * area(half.wall.rest) - lung, 1e-15);
    }
}

TEST(Hemithorax, TheChestsCoordinatesWidenTheCavity) {
  const Hemithorax half = makeHemithorax({});
  std::vector<Vector2d> moved(half.wall.rest.size());
  for (const Vector2d& q : {Vector2d(0.01, 0), Vector2d(0, 0.01)}) {
    for (std::size_t k = 0; k < moved.size(); ++k) moved[k] = half.wall.at(k, q);
    EXPECT_GT(area(moved), area(half.wall.rest) + 5e-4);
    EXPECT_EQ(moved[0], half.wall.rest[0]) << "the hilum stays";
  }
}

TEST(Hemithorax, MirroredIsTheSameToTheBit) {
  const Hemithorax left = makeHemithorax({});
  const Hemithorax right = makeHemithorax({.isMirrored = true});
  for (std::size_t i = 0; i < left.lung.points.size(); ++i)
    EXPECT_EQ(left.lung.points[i], Vector2d(-right.lung.points[i].x(), right.lung.points[i].y()));
  for (std::size_t k = 0; k < left.wall.rest.size(); ++k)
    EXPECT_EQ(left.wall.rest[k], Vector2d(-right.wall.rest[k].x(), right.wall.rest[k].y()));
}

TEST(Hemithorax, TheWoundIsAGapOfItsLengthInTheLateralWall) {
  for (const double length : {0.01, 0.02, 0.05}) {
    const Hemithorax half = makeHemithorax({.woundLength = length, .rings = 12});
    const auto whole = half.wallLine(false);
    const auto open = half.wallLine(true);
    EXPECT_EQ(whole.front(), whole.back());
    EXPECT_EQ(open.front(), half.wall.woundEnd);
    EXPECT_EQ(open.back(), half.wall.woundBegin);
    const auto point = [&](int k) { return half.wall.rest[static_cast<std::size_t>(k)]; };
    const double gap = (point(open.front()) - point(open.back())).norm();
    EXPECT_NEAR(gap, length, 0.006) << "within one segment";
    EXPECT_GT(point(open.back()).x(), 0.1);
    EXPECT_NEAR((point(open.front()).y() + point(open.back()).y()) / 2, 0.02, 0.006);
  }
  const Hemithorax none = makeHemithorax({.woundLength = 0});
  EXPECT_EQ(none.wallLine(true).size(), none.wallLine(false).size());
}

TEST(Hemithorax, ParametersOutsideTheirRangeAreRefused) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<std::function<void(HemithoraxShape&)>> faults{
      [](auto& s) { s.width = 0; },           [](auto& s) { s.width = kNaN; },
      [](auto& s) { s.height = -1; },         [](auto& s) { s.height = kInfinity; },
      [](auto& s) { s.domeHeight = 0; },      [](auto& s) { s.domeHeight = 0.1; },
      [](auto& s) { s.midlineToHilum = -1; }, [](auto& s) { s.naturalScale = 1; },
      [](auto& s) { s.naturalScale = 0; },    [](auto& s) { s.film = 0; },
      [](auto& s) { s.woundHeight = kNaN; },  [](auto& s) { s.woundLength = 1; },
      [](auto& s) { s.rings = 2; },           [](auto& s) { s.rings = 1000; }};
  for (std::size_t i = 0; i < faults.size(); ++i) {
    HemithoraxShape shape;
    faults[i](shape);
    EXPECT_THROW(makeHemithorax(shape), std::invalid_argument) << i;
  }
}

}  // namespace
}  // namespace pleura::planar
