#include <cmath>
#include <numbers>
#include <type_traits>

#include "solid_bodies.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/corotational_solid.h>
#include <pleura/nodes/deformable/fem/linear_solid.h>
#include <pleura/nodes/deformable/fem/neo_hookean_solid.h>

// What the corotational and the Neo-Hookean solver share: large rotations, and states far from any sense.

namespace pleura {
namespace {

template <class Solid>
class NonlinearSolids : public ::testing::Test {};

using Both = ::testing::Types<CorotationalSolid, NeoHookeanSolid>;
TYPED_TEST_SUITE(NonlinearSolids, Both);

constexpr int kKinds[] = {4, 8};

SolidState still(NodeVectors positions) {
  const std::size_t count = positions.size();
  return {std::move(positions), NodeVectors(count, Eigen::Vector3d::Zero())};
}

double farthest(const NodeVectors& a, const NodeVectors& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

NodeVectors shaken(const SolidMesh& mesh, double by) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-by, by);
  NodeVectors positions = mesh.nodes;
  for (auto& x : positions) x += Eigen::Vector3d(uniform(random), uniform(random), uniform(random));
  return positions;
}

TYPED_TEST(NonlinearSolids, ForcesAreSlopesOfEnergy) {
  for (const int kind : kKinds)
    for (const double by : {0.05, 1.}) {  // the second turns elements inside out
      SolidMesh mesh = cube(2, kind);
      distort(mesh, 0.1);
      TypeParam solid(mesh, softCube(), {});
      const NodeVectors at = shaken(mesh, by);
      ASSERT_TRUE(solid.setState(still(at)));
      const NodeVectors forces = solid.elasticForces();
      double size = 0;
      for (const auto& f : forces) size = std::max(size, f.norm());
      const double step = 1e-6;
      for (std::size_t i = 0; i < at.size(); i += 5)
        for (int axis = 0; axis < 3; ++axis) {
          NodeVectors moved = at;
          moved[i][axis] += step;
          solid.setState(still(moved));
          const double ahead = solid.energy();
          moved[i][axis] -= 2 * step;
          solid.setState(still(moved));
          EXPECT_NEAR(forces[i][axis], (solid.energy() - ahead) / (2 * step), 2e-6 * size)
              << kind << " nodes, shaken by " << by;
        }
    }
}

TYPED_TEST(NonlinearSolids, ATurnedBodyIsAtRest) {
  const Eigen::Isometry3d turns[] = {
      Eigen::Isometry3d(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX())),
      Eigen::Translation3d(1, 2, 3) *
          Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d(1, 1, 0).normalized())};
  for (const int kind : kKinds)
    for (const auto& turn : turns) {
      const SolidMesh mesh = cube(2, kind);
      TypeParam solid(mesh, softCube(), {});
      NodeVectors positions;
      for (const auto& x : mesh.nodes) positions.push_back(turn * x);
      ASSERT_TRUE(solid.setState(still(positions)));
      for (const auto& f : solid.elasticForces()) EXPECT_LT(f.norm(), 1e-10);
      EXPECT_NEAR(solid.energy(), 0, 1e-10);
    }
}

// Sinks as much when body, load and clamp are turned by 90 degrees, from the rest shape unturned.
TYPED_TEST(NonlinearSolids, ATurnedCaseHasTheTurnedAnswer) {
  const SolidMesh mesh = cube(3, 4);
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d(0, 1, 0)));
  TypeParam solid(mesh, softCube(), {clampedFace(mesh), {}});
  const Eigen::Vector3d g(0, 0, -1000);
  const NodeVectors forces = weights(solid.body().mass, g);
  ASSERT_TRUE(solid.step(kStatic, {.forces = forces}).converged());
  const NodeVectors expected = solid.state().position;
  EXPECT_GT(farthest(expected, mesh.nodes), 0.08);

  NodeVectors positions;
  for (const auto& x : mesh.nodes) positions.push_back(turn * x);
  ASSERT_TRUE(solid.setState(still(positions)));
  const NodeVectors turned = weights(solid.body().mass, turn * g);
  ASSERT_TRUE(solid.step(kStatic, {.forces = turned}).converged());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_LT((solid.state().position[i] - turn * expected[i]).norm(), 1e-7);
}

// With small strains the answer is the linear one.
TYPED_TEST(NonlinearSolids, SmallStrainsAreLinear) {
  for (const int kind : kKinds)
    for (const double nu : {0.3, 0.499}) {
      SolidMesh mesh = cube(3, kind);
      distort(mesh, 0.05);
      SolidMaterial material = softCube();
      material.poissonRatio = nu;
      LinearSolid linear(mesh, material, {clampedFace(mesh), {}});
      TypeParam solid(mesh, material, {clampedFace(mesh), {}});
      const NodeVectors forces = weights(solid.body().mass, {0, 0, -0.01});
      ASSERT_TRUE(linear.step(kStatic, {.forces = forces}).converged());
      ASSERT_TRUE(solid.step(kStatic, {.forces = forces}).converged());
      EXPECT_LT(farthest(solid.state().position, linear.state().position),
                2e-5 * farthest(linear.state().position, mesh.nodes));
    }
}

// At rest the preconditioner is the system: conjugate gradients take a step, and one to see it. With soft
// points they do hardly more when all is turned.
TEST(CorotationalSolid, IsPreconditionedByItsSystemTurned) {
  const SolidMesh mesh = cube(3, 8);
  CorotationalOptions options;
  options.iterations = 1;
  for (const double beta : {0., 0.5}) {
    SolidMaterial material = softCube();
    material.stiffnessDamping = beta;
    CorotationalSolid solid(mesh, material, {clampedFace(mesh), {}}, options);
    const NodeVectors forces = weights(solid.body().mass, {0, 0, -1e-3});
    EXPECT_LE(solid.step(0.01, {.forces = forces}).iterations, 2) << beta;
  }
  int iterations[2];
  for (const bool isTurned : {false, true}) {
    const Eigen::AngleAxisd turn(isTurned ? 2 : 0, Eigen::Vector3d(1, 2, 3).normalized());
    SolidConstraints held;
    held.soft.stiffness = 1e6;
    NodeVectors positions, targets;
    for (const auto& x : mesh.nodes) positions.push_back(turn * x);
    for (const int i : clampedFace(mesh)) {
      held.soft.node.push_back(i);
      held.soft.weight.push_back(1);
      held.soft.begin.push_back(static_cast<int>(held.soft.node.size()));
      targets.push_back(positions[static_cast<std::size_t>(i)]);
    }
    CorotationalSolid solid(mesh, softCube(), held, options);
    ASSERT_TRUE(solid.setState(still(positions)));
    const NodeVectors forces = weights(solid.body().mass, turn * Eigen::Vector3d(0, 0, -1e-3));
    iterations[isTurned] = solid.step(kStatic, {.forces = forces, .targets = targets}).iterations;
  }
  EXPECT_LE(iterations[0], 2);
  EXPECT_LE(iterations[1], 8);
}

// The tangent is that of the forces, where nothing of it is left out for being negative: beside the answer,
// all swollen by a tenth, one linearisation leaves the square of the error.
TEST(NeoHookeanSolid, ConvergesQuadratically) {
  for (const int kind : kKinds) {
    const SolidMesh mesh = cube(3, kind);
    const auto surface =
        nodesWhere(mesh, [](const auto& x) { return x.minCoeff() <= 0 || x.maxCoeff() >= 1; });
    NodeVectors answer, beside = shaken(mesh, 1e-4);
    for (const auto& x : mesh.nodes) answer.push_back(1.1 * x);
    for (std::size_t i = 0; i < beside.size(); ++i) beside[i] += answer[i] - mesh.nodes[i];
    for (const int i : surface) beside[i] = answer[i];
    NeoHookeanSolid solid(mesh, softCube(), {surface, {}}, {.iterations = 1});
    ASSERT_TRUE(solid.setState(still(beside)));
    solid.step(kStatic, {});
    EXPECT_GT(farthest(beside, answer), 5e-5);
    EXPECT_LT(farthest(solid.state().position, answer), 2e-7) << kind << " nodes";
  }
}

// Steps of 0.1 s with damping, from wherever, until the body is at rest in its shape.
template <class Solid>
void expectRecovery(const SolidMesh& mesh, const NodeVectors& from, const char* what) {
  SolidMaterial material = softCube();
  material.massDamping = 10;
  Solid solid(mesh, material, {clampedFace(mesh), {}}, {});
  SolidState state = still(from);
  for (const int i : clampedFace(mesh)) state.position[i] = mesh.nodes[i];
  ASSERT_TRUE(solid.setState(state));
  for (int i = 0; i < 200 && farthest(solid.state().position, mesh.nodes) > 1e-6; ++i) {
    const SolidReport report = solid.step(0.1, {});
    ASSERT_NE(report.outcome, SolidOutcome::singular) << what;
    ASSERT_NE(report.outcome, SolidOutcome::failed) << what << ", step " << i << ", " << report.residual;
    for (const auto& x : solid.state().position) ASSERT_LT(x.norm(), 100);
  }
  EXPECT_LT(farthest(solid.state().position, mesh.nodes), 1e-6) << what;
}

/// The face is asked to be kilometres away, each node elsewhere: the step fails, and the next is that of a
/// solver which never heard of it.
TEST(NeoHookeanSolid, AFailedStepLeavesNoTrace) {
  const SolidMesh mesh = cube(2, 4);
  SolidConstraints held;
  held.fixed = clampedFace(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> far(-1e4, 1e4);
  NodeVectors scattered, pulled;
  for (const int i : held.fixed) {
    const Eigen::Vector3d& rest = mesh.nodes[static_cast<std::size_t>(i)];
    const double x = far(random), y = far(random), z = far(random);
    scattered.push_back(rest + Eigen::Vector3d(x, y, z));
    pulled.push_back(rest - Eigen::Vector3d(0.1, 0, 0));
  }
  NeoHookeanSolid tried(mesh, softCube(), held), fresh(mesh, softCube(), held);
  ASSERT_EQ(tried.step(0.01, {.prescribed = scattered}).outcome, SolidOutcome::failed);
  ASSERT_TRUE(tried.step(0.01, {.prescribed = pulled}).converged());
  fresh.step(0.01, {.prescribed = pulled});
  EXPECT_EQ(tried.state().position, fresh.state().position);
  EXPECT_EQ(tried.state().velocity, fresh.state().velocity);
}

TYPED_TEST(NonlinearSolids, RecoverFromAnything) {
  for (const int kind : kKinds) {
    const SolidMesh mesh = cube(3, kind);
    const auto mapped = [&](auto map) {
      NodeVectors positions;
      for (const auto& x : mesh.nodes) positions.push_back(map(x));
      return positions;
    };
    const auto scaled = [&](double x, double y, double z) {
      return mapped([=](const Eigen::Vector3d& p) -> Eigen::Vector3d {
        return p.cwiseProduct(Eigen::Vector3d(x, y, z));
      });
    };
    expectRecovery<TypeParam>(mesh, scaled(1, 1, 0), "a plane");
    expectRecovery<TypeParam>(mesh, scaled(1, 0, 0), "a line");
    expectRecovery<TypeParam>(mesh, scaled(0, 0, 0), "a point");
    expectRecovery<TypeParam>(mesh, scaled(-1, 1, 1), "mirrored");
    expectRecovery<TypeParam>(mesh, scaled(10, 1, 1), "stretched tenfold");
    expectRecovery<TypeParam>(
        mesh, mapped([](const Eigen::Vector3d& p) -> Eigen::Vector3d {
          const Eigen::Vector3d axis(0, 0.5, 0.5);
          return axis +
                 Eigen::AngleAxisd(2 * std::numbers::pi * p.x(), Eigen::Vector3d::UnitX()) * (p - axis);
        }),
        "twisted by 360 degrees");
    NodeVectors scrambled = mesh.nodes;
    std::shuffle(scrambled.begin(), scrambled.end(), std::mt19937(2));
    expectRecovery<TypeParam>(mesh, scrambled, "scrambled");
  }
}

// Both ends driven ten times apart, onto each other and back. In between it may say that it has not
// converged.
TYPED_TEST(NonlinearSolids, DrivenThroughExtremes) {
  const SolidMesh mesh = cube(3, 4);
  const auto ends = nodesWhere(mesh, [](const auto& x) { return x.x() <= 0 || x.x() >= 1; });
  TypeParam solid(mesh, softCube(), {ends, {}});
  const auto drive = [&](double stretch) {
    NodeVectors prescribed;
    for (const int i : ends) prescribed.push_back(mesh.nodes[i].cwiseProduct(Eigen::Vector3d(stretch, 1, 1)));
    const SolidReport report = solid.step(kStatic, {.prescribed = prescribed});
    EXPECT_TRUE(report.converged() || report.outcome == SolidOutcome::stopped) << stretch;
    for (std::size_t k = 0; k < ends.size(); ++k)
      EXPECT_LT((solid.state().position[ends[k]] - prescribed[k]).norm(), 1e-14);
    return report.converged();
  };
  // The corotational tangent leaves out the stiffness that such a stretch adds: it comes nearer, slowly.
  EXPECT_TRUE(drive(10) || (std::is_same_v<TypeParam, CorotationalSolid>));
  drive(0);
  for (int i = 0; i < 40 && farthest(solid.state().position, mesh.nodes) > 1e-6; ++i) drive(1);
  EXPECT_LT(farthest(solid.state().position, mesh.nodes), 1e-6);
}

// More linearisations are never worse.
TYPED_TEST(NonlinearSolids, MoreIterationsAreNotWorse) {
  const SolidMesh mesh = cube(3, 4);
  double before = std::numeric_limits<double>::infinity();
  for (const int iterations : {1, 2, 3, 5, 10, 30}) {
    typename std::conditional_t<std::is_same_v<TypeParam, CorotationalSolid>, CorotationalOptions,
                                NewtonOptions>
        options;
    options.iterations = iterations;
    TypeParam solid(mesh, softCube(), {clampedFace(mesh), {}}, options);
    const NodeVectors forces = weights(solid.body().mass, {0, 0, -1000});
    solid.step(kStatic, {.forces = forces});
    double potential = solid.energy();
    for (std::size_t i = 0; i < forces.size(); ++i)
      potential -= forces[i].dot(solid.state().position[i] - mesh.nodes[i]);
    EXPECT_LE(potential, before + 1e-9 * std::abs(potential));
    before = potential;
  }
}

}  // namespace
}  // namespace pleura
