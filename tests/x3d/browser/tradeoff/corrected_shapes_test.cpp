#include <gtest/gtest.h>

#include <pleura/x3d/browser/tradeoff/corrected_shapes.h>

namespace pleura {
namespace {

using Shapes = std::vector<std::vector<Vec3f>>;

/// A model whose answer is `limit`, off by 0.3 h.
Shapes found(const Vec3f& limit, float h) { return {{limit + Vec3f(0.3f * h, 0, 0)}, {limit}}; }

TEST(CorrectedShapes, HaveTheErrorOfTheFinerLattice) {
  const Vec3f limit(1, 2, 3), cheapLimit(1.5f, 2, 3);
  const Shapes corrected =
      correctedShapes(found(limit, 0.1f), found(cheapLimit, 0.02f), found(cheapLimit, 0.1f));
  ASSERT_EQ(corrected.size(), 2u);
  EXPECT_NEAR(corrected[0][0].x(), 1.006f, 1e-6f);
  EXPECT_EQ(corrected[1][0], limit) << "where all agree nothing changes";
}

TEST(CorrectedShapes, WhatAllHaveDrivenToOnePlaceStaysThere) {
  const Vec3f target(0.123456f, -7.1f, 1e-5f);
  EXPECT_EQ(correctedShapes({{target}}, {{target}}, {{target}})[0][0], target);
}

}  // namespace
}  // namespace pleura
