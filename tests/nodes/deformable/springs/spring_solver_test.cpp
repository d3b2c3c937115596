#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

#include "elastic_surface.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/springs/spring_energy.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

bool sameBits(const Points& a, const Points& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

const SpringOptions kExact{1e-10, 100, 2000};

// The radius s of 3 n R T / s = k (s - 1) sum(l^2), sum(l^2) that of equilateral triangles:
// 30,720 edges of 4 pi / 20,480 4 / sqrt(3) m^2 each are 43.53 m^2.
TEST(SpringSolver, ABalloonSwellsByTheClosedForm) {
  ElasticSurface surface = balloon(32);
  ASSERT_EQ(surface.positions.size(), 10242u);
  const double squares = 30720 * (4 * std::numbers::pi / 20480) * 4 / std::sqrt(3.0);
  EXPECT_NEAR(squares, 43.53, 0.005);
  const double s = (1 + std::sqrt(1 + 4 * 300 / (1e4 * squares))) / 2;
  const SpringReport report = surface.solve();
  EXPECT_TRUE(report.converged);
  EXPECT_NEAR((report.volume / surface.model.restVolume - 1) / (s * s * s - 1), 1, 0.01);
  EXPECT_NEAR(report.pressure * report.volume, 100, 1e-9);
}

TEST(SpringSolver, AtRestNothingMoves) {
  for (const SpringInterior& interior : {SpringInterior(EmptyInterior()), SpringInterior(VolumeInterior())}) {
    ElasticSurface surface(geodesicSphere(4, 1), {}, interior);
    const SpringReport report = surface.solve();
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, 0);
    EXPECT_TRUE(sameBits(surface.positions, surface.model.rest));
  }
}

TEST(SpringSolver, GasAtAmbientPressureIsAtRest) {
  const double volume = ElasticSurface(geodesicSphere(8, 1), {}, VolumeInterior()).model.restVolume;
  ElasticSurface surface(geodesicSphere(8, 1), {}, GasInterior{101325 * volume, 101325});
  const SpringReport report = surface.solve();
  EXPECT_NEAR(report.pressure, 0, 1e-9);
  EXPECT_LT(largestDistance(surface.positions, surface.model.rest), 1e-12);
}

/// A ball of gas with a ring around it and its poles driven.
struct Squeezed {
  ElasticSurface surface;
  std::vector<int> driven;
  Points targets;

  explicit Squeezed(const SpringInterior& interior, int cuts = 8)
      : surface(geodesicSphere(cuts, 1), {{100}, {0.01}, 0.05}, interior) {
    for (int i = 0; i < surface.model.pointCount(); ++i) {
      const Vector3d p = surface.model.rest[i];
      if (std::abs(p.z()) < 0.8) continue;
      driven.push_back(i);
      targets.push_back(p - Vector3d(0, 0, 0.1 * p.z()));
    }
  }
  SpringReport solve(const SpringOptions& options = {}) { return surface.solve(driven, targets, options); }
};

TEST(SpringSolver, DrivenPointsAreExactAndForcesBalanceElsewhere) {
  for (const SpringInterior& interior :
       {SpringInterior(GasInterior{600, 40}), SpringInterior(PressureInterior{40})}) {
    Squeezed ball(interior);
    const SpringReport report = ball.solve();
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.residual, 1e-6);
    for (std::size_t i = 0; i < ball.driven.size(); ++i)
      EXPECT_EQ(ball.surface.positions[ball.driven[i]], ball.targets[i]);
    ball.surface.workspace.trial = ball.surface.positions;
    const SpringEnergy energy = evaluateSprings(ball.surface.model, ball.surface.workspace);
    EXPECT_EQ(energy.unbalanced / ball.surface.model.forceUnit, report.residual);
  }
}

TEST(SpringSolver, AVolumeIsHeld) {
  Squeezed ball(VolumeInterior{});
  const SpringReport report = ball.solve();
  EXPECT_TRUE(report.converged);
  EXPECT_NEAR(report.volume / ball.surface.model.restVolume, 1, 1e-6);
  EXPECT_GT(report.pressure, 1) << "squeezed, it pushes back";
  EXPECT_GT(
      std::accumulate(ball.surface.positions.begin(), ball.surface.positions.end(), 0.0,
                      [](double most, const Vector3d& p) { return std::max(most, p.head<2>().norm()); }),
      1.02)
      << "and bulges";
}

TEST(SpringSolver, HasNoMemory) {
  for (const SpringInterior& interior :
       {SpringInterior(GasInterior{600, 40}), SpringInterior(VolumeInterior())}) {
    Squeezed ball(interior);
    ball.solve();
    const Points first = ball.surface.positions;
    ball.surface.solve({0, 5}, {{3, 0, 0}, {-3, 1, 0}});
    ball.surface.step(0.1, {0}, {{2, 2, 2}});
    for (Vector3d& p : ball.surface.positions) p.setConstant(7);
    ball.solve();
    EXPECT_TRUE(sameBits(ball.surface.positions, first));
  }
}

TEST(SpringSolver, OrderOfPointsAndTrianglesDoesNotMatter) {
  Squeezed ball(GasInterior{600, 40});
  ball.solve(kExact);
  std::mt19937 random(1);
  std::vector<int> to(ball.surface.mesh.points.size());
  std::iota(to.begin(), to.end(), 0);
  std::shuffle(to.begin(), to.end(), random);
  TriangleMesh mesh = ball.surface.mesh;
  for (std::size_t i = 0; i < to.size(); ++i) mesh.points[to[i]] = ball.surface.mesh.points[i];
  for (Eigen::Vector3i& t : mesh.triangles) t = Eigen::Vector3i(to[t[1]], to[t[2]], to[t[0]]);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  ElasticSurface other(mesh, {{100}, {0.01}, 0.05}, GasInterior{600, 40});
  std::vector<int> driven;
  for (const int i : ball.driven) driven.push_back(to[i]);
  other.solve(driven, ball.targets, kExact);
  for (std::size_t i = 0; i < to.size(); ++i)
    EXPECT_LT((other.positions[to[i]] - ball.surface.positions[i]).norm(), 1e-8);
}

TEST(SpringSolver, TurnedItIsTheSameAnswerTurned) {
  Squeezed ball(GasInterior{600, 40});
  ball.solve(kExact);
  const Points straight = ball.surface.positions;
  const Eigen::Isometry3d turn = Eigen::Translation3d(5, 0, -3) *
                                 Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d(1, 1, 0).normalized());
  for (Vector3d& target : ball.targets) target = turn * target;
  ball.solve(kExact);
  for (std::size_t i = 0; i < straight.size(); ++i)
    EXPECT_LT((ball.surface.positions[i] - turn * straight[i]).norm(), 1e-8) << "only the targets turned";

  TriangleMesh mesh = ball.surface.mesh;
  const Eigen::Quaterniond quarter(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()));
  for (Eigen::Vector3f& p : mesh.points) p = Eigen::Vector3f(p.x(), -p.z(), p.y());
  ElasticSurface turned(mesh, {{100}, {0.01}, 0.05}, GasInterior{600, 40});
  for (std::size_t i = 0; i < ball.targets.size(); ++i)
    ball.targets[i] = quarter * (turn.inverse() * ball.targets[i]);
  turned.solve(ball.driven, ball.targets, kExact);
  for (std::size_t i = 0; i < straight.size(); ++i)
    EXPECT_LT((turned.positions[i] - quarter * straight[i]).norm(), 1e-8) << "the mesh as well";
}

TEST(SpringSolver, AHundredMetresAwayNothingChanges) {
  Squeezed ball(GasInterior{600, 40});
  ball.solve(kExact);
  const Points here = ball.surface.positions;
  const Vector3d away(100, -100, 100);
  for (Vector3d& target : ball.targets) target += away;
  ball.solve(kExact);
  for (std::size_t i = 0; i < here.size(); ++i)
    EXPECT_LT((ball.surface.positions[i] - away - here[i]).norm(), 1e-8);
}

TEST(SpringSolver, MoreIterationsAreNeverWorse) {
  for (const SpringInterior& interior :
       {SpringInterior(EmptyInterior()), SpringInterior(GasInterior{600, 40})}) {
    Squeezed ball(interior);
    double last = std::numeric_limits<double>::infinity();
    for (int iterations = 1; iterations < 30; ++iterations) {
      ball.solve({1e-12, iterations, 2000});
      const double energy = storedEnergy(ball.surface.model, ball.surface.workspace, ball.surface.positions);
      EXPECT_LE(energy, last + 1e-12 * std::abs(last)) << iterations;
      last = energy;
    }
  }
}

// 0, 1 and all points driven.
TEST(SpringSolver, NoneOneOrAllDriven) {
  ElasticSurface surface = balloon(4);
  surface.solve({}, {}, kExact);
  const Points swollen = surface.positions;
  const Vector3d to(3, 2, 1);
  EXPECT_TRUE(surface.solve({7}, {to}, kExact).converged);
  EXPECT_EQ(surface.positions[7], to);
  // one point leaves the turn about it open
  for (std::size_t i = 0; i < swollen.size(); ++i)
    EXPECT_NEAR((surface.positions[i] - to).norm(), (swollen[i] - swollen[7]).norm(), 1e-7) << "goes along";
  std::vector<int> all(swollen.size());
  std::iota(all.begin(), all.end(), 0);
  Points targets = surface.model.rest;
  for (Vector3d& p : targets) p = Vector3d(p.y(), 2 * p.x(), -p.z());
  EXPECT_TRUE(surface.solve(all, targets).converged) << "no force is left on a point that is free";
  EXPECT_EQ(surface.positions, targets);
}

// --- in motion ---

double totalEnergy(ElasticSurface& surface) {
  double energy = storedEnergy(surface.model, surface.workspace, surface.state.positions);
  for (std::size_t i = 0; i < surface.state.velocities.size(); ++i)
    energy += surface.model.mass[i] * surface.state.velocities[i].squaredNorm() / 2;
  return energy;
}

TEST(SpringSolver, NeverGainsEnergyWithoutLoad) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shake(-1, 1);
  for (const SpringInterior& interior :
       {SpringInterior(EmptyInterior()), SpringInterior(GasInterior{100, 40}),
        SpringInterior(PressureInterior{-50}), SpringInterior(VolumeInterior())})
    for (const double step : {1e-4, 1e-2, 0.3, 1e3})
      for (const double damper : {0.0, 0.1}) {
        ElasticSurface surface(geodesicSphere(3, 1), {{100}, {0.02}, damper}, interior);
        // crushed, with springs that turn over
        for (Vector3d& p : surface.state.positions) p *= 0.6 + 0.2 * shake(random);
        for (Vector3d& v : surface.state.velocities)
          v = 5 * Vector3d(shake(random), shake(random), shake(random));
        if (std::holds_alternative<VolumeInterior>(interior)) surface.state.positions = surface.model.rest;
        const double start = totalEnergy(surface);
        for (double last = start, i = 0; i < 40; ++i) {
          surface.step(step);
          const double energy = totalEnergy(surface);
          EXPECT_LE(energy, last + 1e-9 * std::abs(start))
              << step << " step " << i << " kind " << interior.index();
          last = energy;
        }
      }
}

TEST(SpringSolver, KeepsMomentumAtEveryStep) {
  for (const double step : {1e-6, 1e-3, 1.0, 1e3}) {
    ElasticSurface surface = balloon(4);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shake(-1, 1);
    Vector3d before = Vector3d::Zero(), after = Vector3d::Zero();
    for (Vector3d& v : surface.state.velocities) {
      v = Vector3d(2, 1, 0) + Vector3d(shake(random), shake(random), shake(random));
      before += v;
    }
    surface.step(step, {}, {}, kExact);
    for (const Vector3d& v : surface.state.velocities) after += v;
    EXPECT_LT((after - before).norm() / before.norm(), 1e-6) << step;
  }
}

TEST(SpringSolver, ASlowMotionIsNotTakenForNone) {
  ElasticSurface surface(geodesicSphere(4, 1), {{1e4}, {1e-4}, 0});
  for (std::size_t i = 0; i < surface.state.velocities.size(); ++i)
    surface.state.velocities[i] = 1e-7 * surface.model.rest[i];
  for (int i = 0; i < 5; ++i) surface.step(1e-6);
  for (std::size_t i = 0; i < surface.state.velocities.size(); ++i)
    EXPECT_LT((surface.state.velocities[i] - 1e-7 * surface.model.rest[i]).norm(), 1e-9);
}

// The balloon as one oscillator: m r'' = 3 n R T / r - k (r - 1) sum(l^2), here by Runge and Kutta's method.
double radiusOfBalloon(double squares, double time) {
  const auto force = [&](double r) { return 300 / r - 1e4 * (r - 1) * squares; };
  double r = 1, v = 0;
  const double h = time / 2000;
  for (int i = 0; i < 2000; ++i) {
    const double a1 = force(r), v2 = v + h / 2 * a1, a2 = force(r + h / 2 * v), v3 = v + h / 2 * a2,
                 a3 = force(r + h / 2 * v2), v4 = v + h * a3, a4 = force(r + h * v3);
    r += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return r;
}

TEST(SpringSolver, IsOfFirstOrderInTheStep) {
  const TriangleMesh icosahedron = geodesicSphere(1, 1);  // whose points stay on a sphere
  const double time = 2e-3;
  double last = 0;
  for (const int steps : {50, 100, 200, 400}) {
    ElasticSurface surface(icosahedron, {{1e4}, {1.0 / 12}, 0}, GasInterior{100, 0});
    double squares = 0;
    for (const double l : surface.model.length) squares += l * l;
    for (int i = 0; i < steps; ++i) surface.step(time / steps, {}, {}, kExact);
    const double error = std::abs(surface.state.positions[0].norm() - radiusOfBalloon(squares, time));
    if (last > 0) {
      EXPECT_NEAR(last / error, 2, 0.25) << "a half of the step, a half of the error";
    }
    last = error;
  }
}

TEST(SpringSolver, ALongStepIsTheStaticAnswer) {
  Squeezed ball(GasInterior{600, 40});
  ball.solve(kExact);
  ball.surface.step(1e3, ball.driven, ball.targets, kExact);
  ball.surface.step(1e3, ball.driven, ball.targets, kExact);
  EXPECT_LT(largestDistance(ball.surface.state.positions, ball.surface.positions), 1e-6);
  for (std::size_t i = 0; i < ball.driven.size(); ++i)
    EXPECT_EQ(ball.surface.state.positions[ball.driven[i]], ball.targets[i]);
}

TEST(SpringSolver, DampersTakeEnergyAndLeaveRigidMotion) {
  double left[2];
  for (const int damped : {0, 1}) {
    ElasticSurface surface(geodesicSphere(2, 1), {{100}, {0.02}, 0.02 * damped});
    for (std::size_t i = 0; i < surface.state.velocities.size(); ++i)
      surface.state.velocities[i] = surface.model.rest[i];
    for (int i = 0; i < 20; ++i) surface.step(1e-3, {}, {}, kExact);
    left[damped] = totalEnergy(surface);
  }
  EXPECT_LT(left[1], 0.5 * left[0]);
  ElasticSurface surface(geodesicSphere(2, 1), {{100}, {0.02}, 10});
  std::fill(surface.state.velocities.begin(), surface.state.velocities.end(), Vector3d(1, 2, 3));
  for (int i = 0; i < 20; ++i) surface.step(0.1);
  for (const Vector3d& v : surface.state.velocities) EXPECT_LT((v - Vector3d(1, 2, 3)).norm(), 1e-9);
}

TEST(SpringSolver, SameStepsSameBits) {
  const auto run = [] {
    Squeezed ball(GasInterior{600, 40}, 4);
    for (int i = 0; i < 20; ++i) ball.surface.step(0.01, ball.driven, ball.targets);
    return ball.surface.state.positions;
  };
  EXPECT_TRUE(sameBits(run(), run()));
}

}  // namespace
}  // namespace pleura
