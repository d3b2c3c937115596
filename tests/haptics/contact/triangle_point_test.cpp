#include <random>

#include "surfaces.h"
#include <gtest/gtest.h>

#include <pleura/haptics/contact/triangle_point.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;

Corners randomTriangle(std::mt19937& random) {
  Corners corners;
  for (int k = 0; k < 3; ++k) corners.col(k) = surfaces::randomPoint(random, 1);
  return corners;
}

/// The way from the nearest point of a convex set to p makes no acute angle with a way into the set.
void expectNearest(const Corners& corners, const Vector3d& p) {
  const auto [point, weights] = nearestOnTriangle(corners, p);
  EXPECT_NEAR(weights.sum(), 1, 1e-12);
  EXPECT_GE(weights.minCoeff(), 0);
  EXPECT_LT((corners * weights - point).norm(), 1e-12);
  for (int k = 0; k < 3; ++k) EXPECT_LT((p - point).dot(corners.col(k) - point), 1e-9);
}

TEST(TrianglePoint, IsTheNearest) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) expectNearest(randomTriangle(random), surfaces::randomPoint(random, 2));
}

TEST(TrianglePoint, IsTheNearestOfTrianglesWithoutArea) {
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    Corners corners = randomTriangle(random);
    const Vector3d p = surfaces::randomPoint(random, 2);
    corners.col(2) = corners.col(0) + 0.3 * (corners.col(1) - corners.col(0));
    expectNearest(corners, p);
    corners.col(2) = corners.col(1);
    expectNearest(corners, p);
    corners.col(1) = corners.col(0);
    expectNearest(corners, p);
    corners.col(2) = corners.col(0);
    expectNearest(corners, p);
  }
}

}  // namespace
}  // namespace pleura::haptics
