#include "solid_bodies.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/solid_body.h>

namespace pleura {
namespace {

// Of quadratic energy: central differences are exact but for rounding.
TEST(SolidBody, ForcesAndStiffnessOfSoftPointsAreSlopesOfTheirEnergy) {
  const SolidMesh mesh = cube(1, 8);
  const SoftPoints soft{{0, 3, 5}, {0, 3, 5, 5, 6}, {0.2, 0.5, 0.3, 1.5, -0.5}, 70};
  const SolidBody body = makeSolidBody(mesh, softCube(), {{}, soft});
  const NodeVectors targets{{0.1, 2, 0.3}, {-1, 0.4, 1}};
  const SolidLoad load{.targets = targets};
  const NodeVectors& at = mesh.nodes;
  NodeVectors forces(8, Eigen::Vector3d::Zero());
  addSoftForces(body, load, at, forces);
  BlockValues stiffness(static_cast<std::size_t>(body.pattern.slotCount()), Eigen::Matrix3d::Zero());
  addSoftStiffness(body, stiffness);
  const double step = 0.5;
  for (std::size_t i = 0; i < at.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      NodeVectors ahead = at, behind = at, move(8, Eigen::Vector3d::Zero()), pulls(8);
      ahead[i][axis] += step;
      behind[i][axis] -= step;
      EXPECT_NEAR(forces[i][axis],
                  (softEnergy(body, load, behind) - softEnergy(body, load, ahead)) / (2 * step), 1e-11);
      NodeVectors changed(8, Eigen::Vector3d::Zero());
      addSoftForces(body, load, ahead, changed);
      move[i][axis] = step;
      multiply(body.pattern, stiffness, move, pulls);
      EXPECT_LT((flat(changed) - flat(forces) + flat(pulls)).norm(), 1e-11);
    }
}

}  // namespace
}  // namespace pleura
