#include <numbers>
#include <stdexcept>

#include "mesh_checks.h"
#include <gtest/gtest.h>

#include <pleura/nodes/thorax/anatomy/implicit_surface.h>

namespace pleura {
namespace {

const Eigen::AlignedBox3d kBox(Eigen::Vector3d(-2, -2, -2), Eigen::Vector3d(2, 2, 2));

double ball(const Eigen::Vector3d& p) { return p.norm() - 1.0; }

TEST(SkinOf, ABallIsClosedRoundAndFull) {
  const TriangleMesh mesh = skinOf(ball, kBox, 0.1);
  EXPECT_EQ(openOrTwistedEdges(mesh), 0);
  EXPECT_NEAR(enclosedVolume(mesh), 4.0 / 3.0 * std::numbers::pi, 0.02);
  for (const Eigen::Vector3f& point : mesh.points) EXPECT_NEAR(point.norm(), 1.0f, 1e-4f);
  for (const double angle : smallestAngles(mesh)) EXPECT_GT(angle, 0.4);
}

// Two balls that touch at a corner of cells, in every position of the grid: ambiguous cells must stay
// two-manifold.
TEST(SkinOf, NearlyTouchingSheetsStayManifold) {
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d offset = Eigen::Vector3d(0.61, 0.6, 0.59) + 0.013 * k * Eigen::Vector3d(1, -1, 1);
    const Solid pair = [&](const Eigen::Vector3d& p) { return std::min(ball(p - offset), ball(p + offset)); };
    EXPECT_EQ(openOrTwistedEdges(skinOf(pair, kBox, 0.11)), 0) << k;
  }
}

TEST(SkinOf, RefusesASolidThatLeavesItsBox) {
  EXPECT_THROW(skinOf([](const Eigen::Vector3d& p) { return p.norm() - 3.0; }, kBox, 0.1),
               std::invalid_argument);
  EXPECT_THROW(skinOf(ball, kBox, 0.0), std::invalid_argument);
}

TEST(SmoothUnion, IsExactAwayFromTheSeamAndNeverLess) {
  EXPECT_EQ(smoothUnion(1.0, 3.0, 0.5), 1.0);
  EXPECT_EQ(smoothIntersection(1.0, 3.0, 0.5), 3.0);
  EXPECT_LT(smoothUnion(1.0, 1.1, 0.5), 1.0);
  EXPECT_GT(smoothIntersection(1.0, 1.1, 0.5), 1.1);
}

}  // namespace
}  // namespace pleura
