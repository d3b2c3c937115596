#include <algorithm>
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

double cube(const Eigen::Vector3d& p) { return p.cwiseAbs().maxCoeff() - 0.5; }

// Two cubes whose edges lie diagonally across the same cells, apart by less than a cell: the skins must not
// grow together in one point a cell, which would leave edges with four triangles.
TEST(SkinOf, NearlyTouchingSheetsStayManifold) {
  const Eigen::Vector3d between(0.035, 0.035, 0.0);
  const Eigen::Vector3d apart(0.54, 0.54, 0.0);
  const Solid pair = [&](const Eigen::Vector3d& p) {
    return std::min(cube(p - between - apart), cube(p - between + apart));
  };
  EXPECT_EQ(openOrTwistedEdges(skinOf(pair, kBox, 0.11)), 0);
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
