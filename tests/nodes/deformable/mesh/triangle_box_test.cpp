#include <algorithm>
#include <random>

#include "shapes.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/triangle_box.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

Corners cornersOf(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  Corners corners;
  corners << a, b, c;
  return corners;
}

TEST(TriangleBox, TellsATriangleThatCutsACornerOffFromOneThatPassesIt) {
  const auto across = [](double s) { return cornersOf({s, 0, 0}, {0, s, 0}, {0, 0, s}); };
  EXPECT_TRUE(meetsCube(across(2.99), Vector3d::Zero(), 1));
  EXPECT_FALSE(meetsCube(across(3.01), Vector3d::Zero(), 1));  // its box meets the cube's all the same
}

TEST(TriangleBox, TellsALineThatPassesAnEdge) {
  const auto line = [](double s) { return cornersOf({s, 0, 0.1}, {0, s, 0.1}, {0, s, 0.1}); };
  EXPECT_TRUE(meetsCube(line(1.99), Vector3d::Zero(), 1));
  EXPECT_FALSE(meetsCube(line(2.01), Vector3d::Zero(), 1));
}

TEST(TriangleBox, HoldsATriangleWithinAndOneAround) {
  EXPECT_TRUE(meetsCube(cornersOf({5.1, 5, 5}, {5, 5.1, 5}, {5, 5, 5.1}), {5, 5, 5}, 0.5));
  EXPECT_TRUE(meetsCube(cornersOf({-99, -99, 0}, {99, -99, 0}, {0, 99, 0}), Vector3d::Zero(), 0.01));
}

/// The least distance in the largest coordinate from the centre, by ternary search over a convex function.
double squareDistance(const Corners& corners, const Vector3d& centre) {
  const auto least = [](auto f) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
    }
    return f((low + high) / 2);
  };
  return least([&](double u) {
    return least([&](double v) {
      const Vector3d p = (1 - u) * corners.col(0) + u * ((1 - v) * corners.col(1) + v * corners.col(2));
      return (p - centre).cwiseAbs().maxCoeff();
    });
  });
}

TEST(TriangleBox, AgreesWithTheNearestPointOfRandomTriangles) {
  std::mt19937 random(3);
  int met = 0, clear = 0;
  for (int i = 0; i < 2000; ++i) {
    const Corners corners =
        cornersOf(shapes::randomPoint(random), shapes::randomPoint(random), shapes::randomPoint(random));
    const Vector3d centre = shapes::randomPoint(random);
    const double distance = squareDistance(corners, centre);
    if (std::abs(distance - 0.3) < 1e-3) continue;  // what the search resolves
    ++clear;
    const bool meets = meetsCube(corners, centre, 0.3);
    met += meets ? 1 : 0;
    EXPECT_EQ(meets, distance < 0.3) << i;
  }
  EXPECT_GT(met, 300);
  EXPECT_GT(clear - met, 300);
}

}  // namespace
}  // namespace pleura
