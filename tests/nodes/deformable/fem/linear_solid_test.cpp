#include "bodies.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/linear_solid.h>

namespace pleura {
namespace {

// How far the tip (1, 0, 0) of the clamped cube sinks [m] under 1 kg, spread over its nodes alike.
double sagOfCube(int n, int nodesPerElement) {
  const SolidMesh mesh = cube(n, nodesPerElement);
  LinearSolid solid(mesh, softCube(), {clampedFace(mesh), {}});
  EXPECT_EQ(solid.degenerateCount(), 0);
  const NodeVectors forces(mesh.nodes.size(),
                           Eigen::Vector3d(0, 0, -9.81 / static_cast<double>(mesh.nodes.size())));
  const SolidReport report = solid.step(kStatic, {.forces = forces});
  EXPECT_TRUE(report.converged());
  EXPECT_LT(report.residual, 1e-9);
  return -solid.state().position[n].z();
}

TEST(LinearSolid, CubeSinksUnderItsOwnWeight) {
  EXPECT_NEAR(sagOfCube(10, 4), 0.001434, 0.003 * 0.001434);
  EXPECT_NEAR(sagOfCube(16, 4), 0.001447, 0.003 * 0.001447);
}

}  // namespace
}  // namespace pleura
