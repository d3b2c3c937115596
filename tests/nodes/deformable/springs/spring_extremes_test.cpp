#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

#include "elastic_surface.h"
#include "no_numbers.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <pleura/tests/nodes/deformable/mesh/shapes.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

constexpr float kRadius = 0.1f;  // [m]

const std::vector<SpringInterior> kInteriors{EmptyInterior(), GasInterior{425, 101325}, PressureInterior{50},
                                             VolumeInterior()};

ElasticSurface ball(const SpringInterior& interior, int cuts = 6) {
  return ElasticSurface(geodesicSphere(cuts, kRadius), {{100}, {1e-4}, 0.01}, interior);
}

void expectFinite(const Points& points, double within) {
  double farthest = 0;
  for (const Vector3d& p : points)
    for (const double x : p) {
      ASSERT_TRUE(std::isfinite(x));
      farthest = std::max(farthest, std::abs(x));
    }
  EXPECT_LE(farthest, within);
}

// From a state in these positions, all points free, steps lead back to a surface that springs and interior
// hold.
void expectRecovery(const Points& positions, const char* what) {
  for (const SpringInterior& interior : kInteriors)
    for (const double step : {1e-6, 1e-2, 1e3}) {
      ElasticSurface surface = ball(interior);
      surface.state.positions = positions;
      SpringReport report;
      for (int i = 0; i < 20; ++i) {
        report = surface.step(step);
        ASSERT_FALSE(report.refused);
        expectFinite(surface.state.positions, 10);
        ASSERT_FALSE(testing::Test::HasFailure())
            << what << ", interior " << interior.index() << ", step " << step;
      }
      EXPECT_TRUE(std::isfinite(report.residual));
      if (step > 1) {
        EXPECT_LT(report.residual, 1e-3) << what << ", interior " << interior.index();
      }
    }
}

TEST(SpringExtremes, RecoversFromScrambledCollapsedMirroredAndTwisted) {
  const Points rest = ball(EmptyInterior()).model.rest;
  std::mt19937 random(1);
  Points scrambled = rest;
  std::shuffle(scrambled.begin(), scrambled.end(), random);
  expectRecovery(scrambled, "scrambled");
  const std::vector<std::pair<Vector3d, const char*>> scales{
      {{1, 1, 0}, "flat"},          {{1, 0, 0}, "a line"},     {{0, 0, 0}, "a point"},
      {{-1, 1, 1}, "mirrored"},     {{10, 10, 10}, "tenfold"}, {{10, 1, 1}, "tenfold along x"},
      {{1e-3, 1e-3, 1e-3}, "small"}};
  for (const auto& [scale, what] : scales) {
    Points positions;
    for (const Vector3d& p : rest) positions.push_back(p.cwiseProduct(scale));
    expectRecovery(positions, what);
  }
  Points twisted;
  for (const Vector3d& p : rest)
    twisted.push_back(Eigen::AngleAxisd(10 * std::numbers::pi * p.y(), Vector3d::UnitY()) * p);
  expectRecovery(twisted, "twisted by 360 degrees");
}

TEST(SpringExtremes, DrivenToTheSameIsFiniteAndExactAndForgotten) {
  const Points rest = ball(EmptyInterior()).model.rest;
  std::mt19937 random(2);
  std::vector<int> driven;
  for (int i = 1; i < static_cast<int>(rest.size()); i += 3) driven.push_back(i);
  Points scrambled;
  for (const int i : driven) scrambled.push_back(rest[i]);
  std::shuffle(scrambled.begin(), scrambled.end(), random);
  std::vector<Points> all{scrambled};
  for (const Vector3d& scale :
       {Vector3d(1, 1, 0), Vector3d(1, 0, 0), Vector3d(0, 0, 0), Vector3d(-1, 1, 1), Vector3d(10, 10, 10)}) {
    all.emplace_back();
    for (const int i : driven) all.back().push_back(rest[i].cwiseProduct(scale));
  }
  all.emplace_back();
  for (const int i : driven)
    all.back().push_back(Eigen::AngleAxisd(10 * std::numbers::pi * rest[i].y(), Vector3d::UnitY()) * rest[i]);
  for (const SpringInterior& interior : kInteriors) {
    ElasticSurface surface = ball(interior);
    surface.solve();
    const Points alone = surface.positions;
    for (const Points& targets : all) {
      const SpringReport report = surface.solve(driven, targets);
      EXPECT_FALSE(report.refused);
      EXPECT_TRUE(std::isfinite(report.residual));
      expectFinite(surface.positions, 10);
      for (std::size_t i = 0; i < driven.size(); ++i) EXPECT_EQ(surface.positions[driven[i]], targets[i]);
      surface.solve();
      EXPECT_EQ(surface.positions, alone);
    }
  }
}

TEST(SpringExtremes, RestShapesThatAreScrambledFlatOrNothing) {
  std::mt19937 random(2);
  for (const Eigen::Vector3f& scale : {Eigen::Vector3f(1, 1, 1), {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}) {
    TriangleMesh mesh = geodesicSphere(4, kRadius);
    std::shuffle(mesh.points.begin(), mesh.points.end(), random);
    for (Eigen::Vector3f& p : mesh.points) p = p.cwiseProduct(scale);
    ElasticSurface surface(mesh);
    EXPECT_TRUE(surface.solve().converged);
    const SpringReport report = surface.solve({0, 9, 77}, {{1, 0, 0}, {0, 1, 0}, {-1, 0, 1}});
    EXPECT_TRUE(std::isfinite(report.residual));
    expectFinite(surface.positions, 2);
    for (const double step : {1e-6, 1e-2, 1e3}) surface.step(step, {0}, {{0.5, 0.5, 0.5}});
    expectFinite(surface.state.positions, 2);
  }
}

TEST(SpringExtremes, SliversDuplicatesIsolatedPointsAndRepeatedTriangles) {
  TriangleMesh mesh = geodesicSphere(4, kRadius);
  const int isolated = static_cast<int>(mesh.points.size());
  mesh.points.emplace_back(9.0f, 9.0f, 9.0f);
  mesh.points[3] = mesh.points[mesh.triangles[0][1]];  // an edge without length, triangles without area
  const Eigen::Vector3i first = mesh.triangles[0];
  mesh.triangles.insert(mesh.triangles.end(), {{0, 0, 0}, {4, 4, 5}, first, {first[0], first[2], first[1]}});
  ElasticSurface surface(mesh, {{100}, {1e-4}, 0}, GasInterior{425, 101325});
  surface.solve();
  expectFinite(surface.positions, 9);
  EXPECT_TRUE(surface.positions[isolated].isApprox(Vector3d(9, 9, 9), 0));
  surface.solve({isolated, 0}, {{1, 1, 1}, {0.2, 0, 0}});
  EXPECT_EQ(surface.positions[isolated], Vector3d(1, 1, 1));
  expectFinite(surface.positions, 2);
  surface.state.velocities[isolated] = Vector3d(1, 0, 0);
  for (int i = 0; i < 5; ++i) surface.step(0.1);
  expectFinite(surface.state.positions, 20);
}

TEST(SpringExtremes, StiffnessRatioOfTenMillion) {
  const TriangleMesh mesh = geodesicSphere(6, kRadius);
  SpringMaterial material{{}, {1e-4}, 0};
  const ElasticSurface plain(mesh);
  for (int a = 0; a < plain.model.pointCount(); ++a)
    for (int s = plain.model.begin[a]; s < plain.model.begin[a + 1]; ++s)
      material.stiffness.push_back(mesh.points[a].y() > 0 ? 1e8 : 10);
  ElasticSurface surface(mesh, material, PressureInterior{20});
  const SpringReport report =
      surface.solve({0, 1}, {plain.model.rest[0], plain.model.rest[1]}, {1e-9, 100, 5000});
  EXPECT_TRUE(report.converged) << report.residual;
  for (int a = 0; a < surface.model.pointCount(); ++a)
    for (int s = surface.model.begin[a]; s < surface.model.begin[a + 1]; ++s)
      if (surface.model.stiffness[s] > 1e7) {
        EXPECT_NEAR((surface.positions[a] - surface.positions[surface.model.end[s]]).norm(),
                    surface.model.length[s], 1e-6)
            << "bone keeps its length";
      }
}

TEST(SpringExtremes, AVolumeTowardsZeroStaysFinite) {
  for (const double squeeze : {1e-1, 1e-3, 1e-6, 0.0, -0.5}) {
    ElasticSurface surface = ball(GasInterior{425, 101325});
    std::vector<int> all(surface.model.rest.size());
    std::iota(all.begin(), all.end(), 0);
    Points targets = surface.model.rest;
    for (Vector3d& p : targets) p.z() *= squeeze;
    SpringReport report = surface.solve(all, targets);
    EXPECT_TRUE(std::isfinite(report.pressure));
    EXPECT_GT(report.pressure, 0);
    if (squeeze >= 1e-3) {
      EXPECT_NEAR((report.pressure + 101325) * report.volume, 425, 1e-6);
    }
    surface.state.positions = targets;
    for (int i = 0; i < 30; ++i) report = surface.step(1e-2);
    expectFinite(surface.state.positions, 1);
    EXPECT_GT(report.volume, 0.5 * surface.model.restVolume) << "and blows up again from " << squeeze;
  }
}

TEST(SpringExtremes, AGasThatIsNoneAndOneThatIsTooMuch) {
  ElasticSurface vacuum = ball(GasInterior{0, 101325});
  SpringReport report = vacuum.solve();
  EXPECT_TRUE(std::isfinite(report.residual));
  expectFinite(vacuum.positions, 1);
  ElasticSurface full = ball(GasInterior{1e12, 0});
  report = full.solve();
  EXPECT_TRUE(std::isfinite(report.residual));
  expectFinite(full.positions, 1e12);
}

// Beyond a stretch of 2 a given pressure finds no balance: it blows up for ever, and says so.
TEST(SpringExtremes, APressureWithoutBalanceIsReported) {
  for (const double pressure : {1e5, 1e12, -1e12}) {
    ElasticSurface surface = ball(PressureInterior{pressure});
    const SpringReport report = surface.solve();
    EXPECT_FALSE(report.converged);
    EXPECT_TRUE(std::isfinite(report.residual));
    expectFinite(surface.positions, 1e12);
    for (int i = 0; i < 100; ++i) surface.step(1);
    expectFinite(surface.state.positions, 1e12);
  }
}

TEST(SpringExtremes, AVolumeThatDrivenPointsDenyIsReported) {
  ElasticSurface surface = ball(VolumeInterior());
  std::vector<int> all(surface.model.rest.size());
  std::iota(all.begin(), all.end(), 0);
  Points targets = surface.model.rest;
  for (Vector3d& p : targets) p *= 0.5;
  const SpringReport report = surface.solve(all, targets);
  EXPECT_FALSE(report.converged);
  EXPECT_NEAR(report.volume / surface.model.restVolume, 0.125, 1e-12);
  EXPECT_EQ(surface.positions, targets);
}

TEST(SpringExtremes, RefusedInputTouchesNothing) {
  ElasticSurface surface = ball(GasInterior{425, 101325});
  surface.solve({0}, {{1, 0, 0}});
  surface.step(0.1, {0}, {{0.2, 0, 0}});
  const Points positions = surface.positions;
  const SpringState state = surface.state;
  const auto expectRefused = [&](const std::vector<int>& driven, const Points& targets,
                                 const SpringOptions& options = {}, double step = 0.1) {
    if (step == 0.1) {
      EXPECT_TRUE(surface.solve(driven, targets, options).refused);
    }
    EXPECT_TRUE(surface.step(step, driven, targets, options).refused);
    EXPECT_EQ(surface.positions, positions);
    EXPECT_EQ(surface.state.positions, state.positions);
    EXPECT_EQ(surface.state.velocities, state.velocities);
  };
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e13})
    expectRefused({0, 1}, {{0, 0, 0}, {0, bad, 0}});
  expectRefused({-1}, {{0, 0, 0}});
  expectRefused({surface.model.pointCount()}, {{0, 0, 0}});
  expectRefused({0, 1}, {{0, 0, 0}});
  expectRefused({4, 4}, {{0, 0, 0}, {1, 0, 0}});
  for (const SpringOptions& options : {SpringOptions{0, 50, 500}, SpringOptions{kNan, 50, 500},
                                       SpringOptions{1e-6, 0, 500}, SpringOptions{1e-6, 50, 0}})
    expectRefused({}, {}, options);
  for (const double step : {0.0, -0.1, 1e-7, 1e4, kNan, kInfinity}) expectRefused({}, {}, {}, step);
  EXPECT_FALSE(surface.solve({4, 4}, {{1, 0, 0}, {1, 0, 0}}).refused) << "twice the same is no contradiction";

  for (const double bad : {kNan, kInfinity}) {
    surface.state.velocities[3].x() = bad;
    EXPECT_TRUE(surface.step(0.1).refused);
    surface.state = state;
    surface.state.positions[3].x() = bad;
    EXPECT_TRUE(surface.step(0.1).refused);
    surface.state = state;
  }
  Points tooFew(3);
  EXPECT_TRUE(solveSprings(surface.model, surface.workspace, {}, {}, {}, tooFew).refused);
  EXPECT_FALSE(surface.step(0.1).refused) << "and goes on";
}

TEST(SpringExtremes, EveryLengthOfStepWithAndWithoutMass) {
  for (const double mass : {0.0, 1e-9, 1e-4, 1e6})
    for (const double step : {1e-6, 1e-4, 1e-2, 1.0, 1e3})
      for (const SpringInterior& interior : kInteriors) {
        ElasticSurface surface(geodesicSphere(3, kRadius), {{100}, {mass}, 1}, interior);
        for (int i = 0; i < 10; ++i)
          surface.step(step, {0, 5},
                       {surface.model.rest[0] + Vector3d(0, 0.01 * i, 0), surface.model.rest[5]});
        expectFinite(surface.state.positions, 2);
        EXPECT_EQ(surface.state.positions[5], surface.model.rest[5]);
      }
}

TEST(SpringExtremes, AHundredThousandStepsOfBreathingDoNotDrift) {
  constexpr int kStepsABreath = 20;
  for (const SpringInterior& interior :
       {SpringInterior(GasInterior{425, 101325}), SpringInterior(VolumeInterior())}) {
    ElasticSurface surface(geodesicSphere(1, kRadius), {{100}, {1e-3}, 0.02}, interior);
    const auto breathe = [&](int step) {
      const double depth =
          0.005 * (1 - std::cos(2 * std::numbers::pi / kStepsABreath * (step % kStepsABreath)));
      const Points& rest = surface.model.rest;
      // enough of them that the others have but one way to follow
      surface.step(0.2, {0, 3, 6, 9}, {rest[0] + Vector3d(0, depth, 0), rest[3], rest[6], rest[9]});
      return surface.state.positions;
    };
    std::vector<Points> early;
    int step = 0;
    for (; step < 10 * kStepsABreath; ++step) breathe(step);
    for (; step < 11 * kStepsABreath; ++step) early.push_back(breathe(step));
    EXPECT_GT(largestDistance(early[0], early[kStepsABreath / 2]), 0.005);
    for (; step < 50000; ++step) breathe(step);
    for (int i = 0; i < kStepsABreath; ++i) EXPECT_LT(largestDistance(breathe(step + i), early[i]), 1e-5);
  }
}

}  // namespace
}  // namespace pleura
