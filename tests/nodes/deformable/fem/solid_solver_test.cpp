#include <array>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "solid_bodies.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/corotational_solid.h>
#include <pleura/nodes/deformable/fem/linear_solid.h>
#include <pleura/nodes/deformable/fem/neo_hookean_solid.h>
#include <pleura/nodes/deformable/fem/solid_solver.h>

// What holds for all three.

namespace pleura {
namespace {

template <class Solid>
class SolidSolvers : public ::testing::Test {};

using All = ::testing::Types<LinearSolid, CorotationalSolid, NeoHookeanSolid>;
TYPED_TEST_SUITE(SolidSolvers, All);

constexpr int kSolvedKinds[] = {4, 8};

std::vector<int> surface(const SolidMesh& mesh) {
  return nodesWhere(mesh, [](const auto& x) { return x.minCoeff() <= 0 || x.maxCoeff() >= 1; });
}

NodeVectors mapped(const SolidMesh& mesh, const std::vector<int>& nodes, const Eigen::Affine3d& map) {
  NodeVectors positions;
  for (const int i : nodes) positions.push_back(map * mesh.nodes[i]);
  return positions;
}

double farthestFrom(const NodeVectors& a, const NodeVectors& b) {
  double farthest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) farthest = std::max(farthest, (a[i] - b[i]).norm());
  return farthest;
}

double kineticEnergy(const SolidBody& body, const SolidState& state) {
  double sum = 0;
  for (std::size_t i = 0; i < state.velocity.size(); ++i)
    sum += 0.5 * body.mass[i] * state.velocity[i].squaredNorm();
  return sum;
}

SolidMaterial soft(double nu) { return {.density = 1, .youngsModulus = 2e4, .poissonRatio = nu}; }

// A patch test: with its surface mapped by x = A X, a body inside is mapped alike, however its mesh is
// distorted.
TYPED_TEST(SolidSolvers, ConstantStrainIsExact) {
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.linear() << 1.02, 0.01, 0, -0.02, 0.99, 0.03, 0.01, 0, 1.01;
  for (const int kind : kSolvedKinds)
    for (const double nu : {0., 0.4, 0.499}) {
      SolidMesh mesh = cube(3, kind);
      distort(mesh, 0.08);
      TypeParam solid(mesh, soft(nu), {surface(mesh), {}});
      const NodeVectors prescribed = mapped(mesh, surface(mesh), map);
      const SolidReport report = solid.step(kStatic, {.prescribed = prescribed});
      EXPECT_TRUE(report.converged()) << kind << " nodes, nu " << nu << ", " << report.residual;
      for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
        EXPECT_LT((solid.state().position[i] - map * mesh.nodes[i]).norm(), 1e-8);
    }
}

TYPED_TEST(SolidSolvers, StaticEqualsAStepOfAThousandSeconds) {
  for (const int kind : kSolvedKinds) {
    const SolidMesh mesh = cube(3, kind);
    TypeParam still(mesh, soft(0.4), {clampedFace(mesh), {}}), slow(mesh, soft(0.4), {clampedFace(mesh), {}});
    const NodeVectors forces = weights(still.body().mass, {0, 0, -300});
    EXPECT_TRUE(still.step(kStatic, {.forces = forces}).converged());
    EXPECT_TRUE(slow.step(1000, {.forces = forces}).converged());
    EXPECT_GT(farthestFrom(still.state().position, mesh.nodes), 0.02);
    EXPECT_LT(farthestFrom(still.state().position, slow.state().position), 1e-8);
  }
}

// Under a load at rest the body is where it was: the answer is a fixed point.
TYPED_TEST(SolidSolvers, AStaticAnswerStays) {
  const SolidMesh mesh = cube(3, 4);
  TypeParam solid(mesh, soft(0.4), {clampedFace(mesh), {}});
  const NodeVectors forces = weights(solid.body().mass, {0, 0, -300});
  solid.step(kStatic, {.forces = forces});
  const NodeVectors answer = solid.state().position;
  EXPECT_TRUE(solid.step(kStatic, {.forces = forces}).converged());
  EXPECT_TRUE(solid.step(0.01, {.forces = forces}).converged());
  EXPECT_LT(farthestFrom(solid.state().position, answer), 1e-7);
}

TYPED_TEST(SolidSolvers, BackwardEulerMakesNoEnergy) {
  for (const double h : {1e-4, 1e-2, 1.}) {
    const SolidMesh mesh = cube(3, 4);
    TypeParam solid(mesh, soft(0.4), {clampedFace(mesh), {}});
    SolidState pulled = solid.state();
    for (auto& x : pulled.position) x += Eigen::Vector3d(0.1 * x.x(), 0, -0.2 * x.x() * x.x());
    for (std::size_t i = 0; i < pulled.velocity.size(); ++i)
      pulled.velocity[i] = Eigen::Vector3d(0, pulled.position[i].x(), 0);
    ASSERT_TRUE(solid.setState(pulled));
    double energy = solid.energy() + kineticEnergy(solid.body(), solid.state());
    const double atStart = energy;
    for (int i = 0; i < 60; ++i) {
      ASSERT_TRUE(solid.step(h, {}).converged());
      const double now = solid.energy() + kineticEnergy(solid.body(), solid.state());
      EXPECT_LE(now, energy * (1 + 1e-12) + 1e-12 * atStart) << "step " << i << " of " << h;
      energy = now;
    }
    EXPECT_LT(energy, atStart);
  }
}

// Backward Euler is of order 1: the error at a time halves with the step.
TYPED_TEST(SolidSolvers, FirstOrderInTime) {
  const auto tipAt = [](int steps) {
    const SolidMesh mesh = cube(2, 4);
    SolidMaterial material = soft(0.3);
    material.massDamping = 2;
    material.stiffnessDamping = 1e-3;
    TypeParam solid(mesh, material, {clampedFace(mesh), {}});
    const NodeVectors forces = weights(solid.body().mass, {0, 0, -200});
    for (int i = 0; i < steps; ++i) EXPECT_TRUE(solid.step(0.02 / steps, {.forces = forces}).converged());
    return solid.state().position[2].z();
  };
  const double a = tipAt(64), b = tipAt(128), c = tipAt(256);
  EXPECT_NEAR(std::log2((a - b) / (b - c)), 1, 0.1);
}

// M ((v1 - v0) / h + alpha v1) + K (u1 + beta v1) = 0, in small motions of a free body from rest.
TYPED_TEST(SolidSolvers, DampingIsAlphaMAndBetaK) {
  const double h = 0.01;
  const SolidMesh mesh = cube(2, 8);
  SolidMaterial material = soft(0.3);
  material.massDamping = 30;
  material.stiffnessDamping = 0.02;
  const LinearSolid linear(mesh, material, {});
  TypeParam solid(mesh, material, {});
  SolidState moving = solid.state();
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    moving.velocity[i] =
        1e-5 * Eigen::Vector3d(std::sin(3. * double(i)), std::cos(5. * double(i)), std::sin(7. * double(i)));
  ASSERT_TRUE(solid.setState(moving));
  ASSERT_TRUE(solid.step(h, {}).converged());
  const NodeVectors& v0 = moving.velocity;
  const NodeVectors& v1 = solid.state().velocity;
  NodeVectors strained(v1.size()), restoring(v1.size());
  for (std::size_t i = 0; i < v1.size(); ++i)
    strained[i] = solid.state().position[i] - mesh.nodes[i] + material.stiffnessDamping * v1[i];
  multiply(linear.body().pattern, linear.stiffness(), strained, restoring);
  double left = 0, size = 0;
  for (std::size_t i = 0; i < v1.size(); ++i) {
    const double m = linear.body().mass[i];
    left += (m * ((v1[i] - v0[i]) / h + material.massDamping * v1[i]) + restoring[i]).squaredNorm();
    size += (m / h * v0[i]).squaredNorm();
  }
  EXPECT_LT(std::sqrt(left / size), 1e-4);
}

TYPED_TEST(SolidSolvers, NoneOneAndAllNodesFixed) {
  const SolidMesh mesh = cube(2, 4);
  std::vector<int> all(mesh.nodes.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  TypeParam none(mesh, soft(0.4), {}), one(mesh, soft(0.4), {{0}, {}}), every(mesh, soft(0.4), {all, {}});
  const NodeVectors forces = weights(none.body().mass, {0, 0, -10});

  for (TypeParam* solid : {&none, &one}) {
    EXPECT_EQ(solid->step(kStatic, {.forces = forces}).outcome, SolidOutcome::singular);
    EXPECT_EQ(farthestFrom(solid->state().position, mesh.nodes), 0);
  }
  EXPECT_TRUE(none.step(0.1, {.forces = forces}).converged());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)  // falls by g h^2
    EXPECT_LT((none.state().position[i] - mesh.nodes[i] - Eigen::Vector3d(0, 0, -0.1)).norm(), 1e-9);
  EXPECT_TRUE(one.step(0.01, {.forces = forces}).converged());

  const NodeVectors moved = mapped(mesh, all, Eigen::Affine3d(Eigen::Translation3d(1, 2, 3)));
  EXPECT_TRUE(every.step(kStatic, {.forces = forces, .prescribed = moved}).converged());
  EXPECT_EQ(farthestFrom(every.state().position, moved), 0);
  EXPECT_TRUE(every.step(0.5, {.prescribed = mesh.nodes}).converged());
  EXPECT_EQ(farthestFrom(every.state().position, mesh.nodes), 0);
  EXPECT_LT((every.state().velocity[4] - Eigen::Vector3d(-2, -4, -6)).norm(), 1e-14);
}

TYPED_TEST(SolidSolvers, SoftPointsHoldAndMove) {
  const SolidMesh mesh = cube(2, 8);
  SoftPoints points;
  NodeVectors targets;
  for (const int e : {0, 3, 5, 6}) {  // the middles of four cells
    for (int a = 0; a < 8; ++a) {
      points.node.push_back(mesh.elements[8 * e + a]);
      points.weight.push_back(0.125);
    }
    points.begin.push_back(static_cast<int>(points.node.size()));
    targets.emplace_back(Eigen::Vector3d(e & 1 ? 0.75 : 0.25, e & 2 ? 0.75 : 0.25, e & 4 ? 0.75 : 0.25));
  }
  points.stiffness = 100;
  TypeParam solid(mesh, soft(0.4), {{}, points});
  EXPECT_TRUE(solid.step(kStatic, {}).converged());
  EXPECT_LT(farthestFrom(solid.state().position, mesh.nodes), 1e-12);
  for (auto& target : targets) target += Eigen::Vector3d(0.3, -0.2, 0.1);
  EXPECT_TRUE(solid.step(kStatic, {.targets = targets}).converged());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    EXPECT_LT((solid.state().position[i] - mesh.nodes[i] - Eigen::Vector3d(0.3, -0.2, 0.1)).norm(), 1e-7);
  // 10 N on four springs of 100 N/m.
  const NodeVectors forces(mesh.nodes.size(), Eigen::Vector3d(10. / 27, 0, 0));
  EXPECT_TRUE(solid.step(kStatic, {.forces = forces, .targets = targets}).converged());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int r = 0; r < points.count(); ++r)
    for (int k = points.begin[r]; k < points.begin[r + 1]; ++k)
      mean += 0.25 * points.weight[k] * solid.state().position[points.node[k]];
  EXPECT_LT((mean - Eigen::Vector3d(0.5 + 0.3 + 10. / 400, 0.3, 0.6)).norm(), 1e-7);
}

TYPED_TEST(SolidSolvers, AHundredMetresAway) {
  const auto sagAt = [](const Eigen::Vector3d& origin) -> Eigen::Vector3d {
    SolidMesh mesh = cube(3, 4);
    const auto clamped = clampedFace(mesh);
    for (auto& x : mesh.nodes) x += origin;
    TypeParam solid(mesh, soft(0.4), {clamped, {}});
    const NodeVectors forces = weights(solid.body().mass, {0, 0, -300});
    EXPECT_TRUE(solid.step(kStatic, {.forces = forces}).converged());
    return solid.state().position[3] - mesh.nodes[3];
  };
  EXPECT_LT((sagAt({100, -100, 100}) - sagAt({0, 0, 0})).norm(), 1e-9);
}

TYPED_TEST(SolidSolvers, WhatIsNotFiniteIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = kStatic;
  const SolidMesh mesh = cube(2, 4);
  TypeParam solid(mesh, soft(0.4), {clampedFace(mesh), {}});
  const NodeVectors forces = weights(solid.body().mass, {0, 0, -10});
  ASSERT_TRUE(solid.step(0.01, {.forces = forces}).converged());
  const SolidState good = solid.state();
  for (const double bad : {nan, infinite, -infinite, 1e10}) {
    NodeVectors broken = forces;
    broken[5].y() = bad;
    NodeVectors prescribed(9, Eigen::Vector3d::Zero());
    prescribed[8].z() = bad;
    EXPECT_EQ(solid.step(0.01, {.forces = broken}).outcome, SolidOutcome::badInput);
    EXPECT_EQ(solid.step(0.01, {.prescribed = prescribed}).outcome, SolidOutcome::badInput);
    SolidState state = good;
    state.velocity[3].x() = bad;
    EXPECT_FALSE(solid.setState(state));
    state = good;
    state.position[3].x() = bad;
    EXPECT_FALSE(solid.setState(state));
  }
  for (const double h : {0., -1., nan, -infinite, 1e-12})
    EXPECT_EQ(solid.step(h, {.forces = forces}).outcome, SolidOutcome::badInput);
  const NodeVectors tooFew(3, Eigen::Vector3d::Zero());
  EXPECT_EQ(solid.step(0.01, {.forces = tooFew}).outcome, SolidOutcome::badInput);
  EXPECT_EQ(solid.step(0.01, {.prescribed = tooFew}).outcome, SolidOutcome::badInput);
  EXPECT_EQ(solid.step(0.01, {.targets = tooFew}).outcome, SolidOutcome::badInput);
  EXPECT_FALSE(solid.setState({tooFew, tooFew}));
  EXPECT_EQ(solid.state().position, good.position);
  EXPECT_EQ(solid.state().velocity, good.velocity);
  EXPECT_TRUE(solid.step(0.01, {.forces = forces}).converged());
}

TYPED_TEST(SolidSolvers, BadConstraintsAreRefused) {
  const SolidMesh mesh = cube(1, 4);
  const auto refuses = [&](const SolidConstraints& constraints) {
    EXPECT_THROW(TypeParam(mesh, softCube(), constraints), std::invalid_argument);
  };
  refuses({{8}, {}});
  refuses({{-1}, {}});
  refuses({{2, 2}, {}});
  refuses({{}, {{0, 1}, {9}, {1}, 1}});
  refuses({{}, {{0, 2}, {1}, {1}, 1}});
  refuses({{}, {{0, 2}, {1, 1}, {0.5, 0.5}, 1}});
  refuses({{}, {{0, 1}, {1}, {1}, -1}});
  refuses({{}, {{0, 1}, {1}, {kStatic}, 1}});
}

TYPED_TEST(SolidSolvers, NodesOfNoElementStay) {
  SolidMesh mesh = cube(2, 4);
  mesh.nodes.insert(mesh.nodes.end(), {{5, 5, 5}, mesh.nodes[0]});  // alone; at the place of another
  TypeParam solid(mesh, soft(0.4), {clampedFace(mesh), {}});
  const NodeVectors forces(mesh.nodes.size(), Eigen::Vector3d(0, 0, -1));
  EXPECT_TRUE(solid.step(0.01, {.forces = forces}).converged());
  EXPECT_EQ(solid.state().position[27], mesh.nodes[27]);
}

// Two bodies stepped side by side in two threads move to the last bit as one after the other: solvers share
// nothing that changes.
TYPED_TEST(SolidSolvers, TwoInTwoThreadsAreAsInOne) {
  const SolidMesh hexahedra = cube(3, 8), tetrahedra = cube(4, 4);
  SolidMaterial material = soft(0.4);
  material.massDamping = 1;
  const auto swing = [](TypeParam& solid) {
    NodeVectors forces;
    for (int i = 0; i < 20; ++i) {
      forces = weights(solid.body().mass, {0, 30. * (i % 3), -100});
      solid.step(0.01, {.forces = forces});
    }
  };
  std::array<SolidState, 2> found[2];
  for (const bool together : {false, true}) {
    TypeParam first(hexahedra, material, {clampedFace(hexahedra), {}});
    TypeParam second(tetrahedra, material, {clampedFace(tetrahedra), {}});
    if (together) {
      const std::jthread beside([&] { swing(first); });
      swing(second);
    } else {
      swing(first);
      swing(second);
    }
    found[together] = {first.state(), second.state()};
  }
  for (const int k : {0, 1}) {
    EXPECT_GT(farthestFrom(found[0][k].position, k == 0 ? hexahedra.nodes : tetrahedra.nodes), 1e-3);
    EXPECT_EQ(found[0][k].position, found[1][k].position);
    EXPECT_EQ(found[0][k].velocity, found[1][k].velocity);
  }
}

// From 1e-6 s to 1e3 s.
TYPED_TEST(SolidSolvers, StepsOfAnyLength) {
  const SolidMesh mesh = cube(3, 4);
  TypeParam solid(mesh, soft(0.4), {clampedFace(mesh), {}});
  const NodeVectors forces = weights(solid.body().mass, {0, 0, -9.81});
  for (int power = -6; power <= 3; ++power) {
    ASSERT_TRUE(solid.setState({mesh.nodes, NodeVectors(mesh.nodes.size(), Eigen::Vector3d::Zero())}));
    const double h = std::pow(10., power);
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(solid.step(h, {.forces = forces}).converged()) << h;
    EXPECT_LT(farthestFrom(solid.state().position, mesh.nodes), 0.003) << h;
    if (power > -6) continue;
    EXPECT_NEAR(solid.state().position[3].z(), -9.81 * 15e-12, 1e-16) << "falls yet by g h^2 (1 + ... + 5)";
  }
}

// Half of the cube ten million times as soft as the other.
TYPED_TEST(SolidSolvers, StiffnessRatioOfTenMillion) {
  SolidMesh mesh = cube(4, 4);
  for (int e = 0; e < mesh.elementCount(); ++e)
    mesh.fill.push_back(
        mesh.nodes[mesh.elements[4 * e]].x() + mesh.nodes[mesh.elements[4 * e + 3]].x() > 1 ? 1 : 1e-7);
  SolidMaterial material = soft(0.4);
  material.youngsModulus = 2e11;
  TypeParam solid(mesh, material, {clampedFace(mesh), {}});
  const NodeVectors forces = weights(solid.body().mass, {0, 0, -9.81});
  for (const double h : {1e-3, 1., kStatic}) {
    const SolidReport report = solid.step(h, {.forces = forces});
    EXPECT_TRUE(report.converged()) << h << ' ' << report.residual << ' ' << int(report.outcome);
  }
  EXPECT_GT(farthestFrom(solid.state().position, mesh.nodes), 1e-5);
}

}  // namespace
}  // namespace pleura
