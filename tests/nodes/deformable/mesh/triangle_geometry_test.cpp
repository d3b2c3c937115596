#include "shapes.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/triangle_geometry.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

Corners randomCorners(std::mt19937& random) {
  Corners corners;
  for (int k = 0; k < 3; ++k) corners.col(k) = shapes::randomPoint(random);
  return corners;
}

/// c is the point of a convex set nearest to p exactly if (p - c) . (v - c) <= 0 for all its corners v.
void expectNearest(const Corners& corners, const Vector3d& p) {
  const TrianglePoint c = closestPointOnTriangle(corners, p);
  for (int k = 0; k < 3; ++k) EXPECT_LT((p - c.point).dot(corners.col(k) - c.point), 1e-12) << corners;
  EXPECT_NEAR(c.weights.sum(), 1, 1e-14);
  EXPECT_GE(c.weights.minCoeff(), 0);
  EXPECT_LT((corners * c.weights - c.point).norm(), 1e-9);
  EXPECT_NEAR(c.squaredDistance, (p - c.point).squaredNorm(), 1e-14);
}

TEST(ClosestPointOnTriangle, IsNearestForAnyTriangleAndPoint) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) expectNearest(randomCorners(random), shapes::randomPoint(random, 2));
}

TEST(ClosestPointOnTriangle, IsNearestForTrianglesWithoutArea) {
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    Corners corners = randomCorners(random);
    const Vector3d p = shapes::randomPoint(random, 2);
    corners.col(i % 3) = 0.25 * corners.col((i + 1) % 3) + 0.75 * corners.col((i + 2) % 3);
    expectNearest(corners, p);
    corners.col(1) = corners.col(0);
    expectNearest(corners, p);
    corners.col(2) = corners.col(0);
    expectNearest(corners, p);
  }
}

TEST(ClosestPointOnTriangle, HasWeightsOfExactlyZeroOffItsEdgeOrCorner) {
  const Corners corners = Corners::Identity();
  EXPECT_EQ(closestPointOnTriangle(corners, {2, -1, -1}).weights, Vector3d(1, 0, 0));
  EXPECT_EQ(closestPointOnTriangle(corners, {1, 1, -3}).weights, Vector3d(0.5, 0.5, 0));
  EXPECT_GT(closestPointOnTriangle(corners, {1, 1, 1}).weights.minCoeff(), 0.33);
}

TEST(Ray, MeetsWhereTheWeightsSay) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> weight(0.01, 1);
  for (int i = 0; i < 1000; ++i) {
    const Corners corners = randomCorners(random);
    Vector3d weights(weight(random), weight(random), weight(random));
    weights /= weights.sum();
    const Vector3d origin = shapes::randomPoint(random, 3);
    const auto hit = Ray(origin, (corners * weights - origin) / 2).meet(corners);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 2, 1e-9);
    EXPECT_LT((hit->weights - weights).norm(), 1e-6);
  }
}

TEST(Ray, MissesBesideTheTriangleAndEdgeOn) {
  const Corners corners = Corners::Identity();
  EXPECT_FALSE(Ray({0, 0, 0}, {1, 1, -0.1}).meet(corners));
  EXPECT_FALSE(Ray({-1, 1, 1}, {2, -1, -1}).meet(corners));
}

}  // namespace
}  // namespace pleura
