#include <random>

#include "surfaces.h"
#include <gtest/gtest.h>

#include <pleura/haptics/contact/half_space_projection.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;

struct HalfSpace {
  Vector3d normal;
  double offset;
};

/// Adds whatever is violated most until nothing is.
bool addAll(HalfSpaceProjection& projection, const std::vector<HalfSpace>& spaces) {
  for (int n = 0; n < 100; ++n) {
    int worst = -1;
    double most = 1e-12;
    for (int k = 0; k < static_cast<int>(spaces.size()); ++k) {
      const double outside = spaces[k].offset - spaces[k].normal.dot(projection.point());
      if (outside > most) {
        most = outside;
        worst = k;
      }
    }
    if (worst < 0) return true;
    if (!projection.add(worst, spaces[worst].normal, spaces[worst].offset)) return false;
  }
  ADD_FAILURE() << "it doesn't end";
  return false;
}

TEST(HalfSpaceProjection, IsTheTargetWhereNothingIsInTheWay) {
  const HalfSpaceProjection projection(Vector3d(1, 2, 3));
  EXPECT_EQ(projection.point(), Vector3d(1, 2, 3));
  EXPECT_TRUE(projection.active().empty());
}

/// What makes a point the nearest one (Karush, Kuhn and Tucker): it is in all half-spaces, and the way from
/// the target to it is a sum of normals with shares >= 0 of those on whose planes it lies.
TEST(HalfSpaceProjection, FulfilsTheConditionsOfTheNearestPoint) {
  std::mt19937 random(1);
  std::array<int, 4> byActive{};
  for (int i = 0; i < 3000; ++i) {
    const Vector3d inside = surfaces::randomPoint(random, 1), target = surfaces::randomPoint(random, 3);
    std::vector<HalfSpace> spaces;
    for (int k = 0; k < 1 + i % 12; ++k) {
      const Vector3d normal = surfaces::randomPoint(random, 1).normalized();
      spaces.push_back({normal, normal.dot(inside) - std::abs(surfaces::randomPoint(random, 0.1)[0])});
    }
    HalfSpaceProjection projection(target);
    ASSERT_TRUE(addAll(projection, spaces));
    Vector3d sum = Vector3d::Zero();
    for (const auto& [label, normal, depth] : projection.active()) {
      EXPECT_GE(depth, 0);
      EXPECT_NEAR(spaces[label].normal.dot(projection.point()), spaces[label].offset, 1e-9);
      sum += depth * normal;
    }
    EXPECT_LT((projection.point() - target - sum).norm(), 1e-9);
    ++byActive[projection.active().size()];
  }
  for (const int count : byActive) EXPECT_GT(count, 100);
}

TEST(HalfSpaceProjection, TellsAnEmptyIntersection) {
  HalfSpaceProjection slab(Vector3d(0, 0, 5));
  EXPECT_TRUE(slab.add(0, -Vector3d::UnitZ(), 1));  // z <= -1
  EXPECT_FALSE(slab.add(1, Vector3d::UnitZ(), 1));  // z >= 1
}

TEST(HalfSpaceProjection, ReplacesPlanesThatAreNearlyParallel) {
  HalfSpaceProjection projection(Vector3d(0, 0, -1));
  const Vector3d tilted = Vector3d(1e-8, 0, 1).normalized();
  EXPECT_TRUE(projection.add(0, Vector3d::UnitZ(), 0));
  EXPECT_TRUE(projection.add(1, tilted, 0.1));
  EXPECT_EQ(projection.active().size(), 1U);
  EXPECT_NEAR(projection.point().z(), 0.1, 1e-12);
  EXPECT_NEAR(projection.active()[0].depth, 1.1, 1e-12);
}

}  // namespace
}  // namespace pleura::haptics
