#include <random>

#include "elastic_surface.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/springs/spring_energy.h>
#include <pleura/tests/nodes/deformable/mesh/shapes.h>

namespace pleura {
namespace {

const std::vector<SpringInterior> kInteriors{EmptyInterior(), GasInterior{100, 40}, PressureInterior{-70},
                                             VolumeInterior()};

Points shaken(const Points& points, std::mt19937& random, double reach) {
  Points result;
  for (const Eigen::Vector3d& p : points)
    result.push_back(p + reach * shapes::randomPoint(random).cast<double>());
  return result;
}

// What a step minimises, at these positions, ready to be evaluated.
SpringEnergy evaluateStep(ElasticSurface& surface, const Points& before, const Points& velocities,
                          const Points& at) {
  prepareForStep(surface.model, surface.workspace, before, velocities, 0.1);
  surface.workspace.hold.multiplier = 20;
  surface.workspace.trial = at;
  return evaluateSprings(surface.model, surface.workspace);
}

// Springs, dampers, inertia and every interior, at a shape far from rest.
TEST(SpringEnergy, ForcesAreItsFiniteDifferences) {
  std::mt19937 random(1);
  for (const SpringInterior& interior : kInteriors) {
    ElasticSurface surface(geodesicSphere(2, 1), {{50}, {0.1}, 0.3}, interior);
    const Points before = shaken(surface.model.rest, random, 0.1), at = shaken(before, random, 0.3);
    const Points velocities = shaken(Points(at.size(), Eigen::Vector3d::Zero()), random, 1);
    evaluateStep(surface, before, velocities, at);
    const Points gradient = surface.workspace.gradient;
    constexpr double kStep = 1e-6;
    for (std::size_t i = 0; i < at.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        Points above = at, below = at;
        above[i][axis] += kStep;
        below[i][axis] -= kStep;
        const double difference = evaluateStep(surface, before, velocities, above).energy -
                                  evaluateStep(surface, before, velocities, below).energy;
        EXPECT_NEAR(difference / (2 * kStep), gradient[i][axis], 1e-6 * surface.model.forceUnit);
      }
  }
}

// Where all springs are stretched nothing of a spring's tangent is left out.
TEST(SpringEnergy, TangentsOfStretchedSpringsAreFiniteDifferencesOfForces) {
  std::mt19937 random(2);
  ElasticSurface surface(geodesicSphere(2, 1), {{50}, {0}, 0});
  Points at = shaken(surface.model.rest, random, 0.05);
  for (Eigen::Vector3d& p : at) p *= 2;
  const auto gradientAt = [&](const Points& points) {
    prepareForRest(surface.model, surface.workspace);
    surface.workspace.trial = points;
    evaluateSprings(surface.model, surface.workspace);
    return surface.workspace.gradient;
  };
  constexpr double kStep = 1e-6;
  const int moved = 5;
  for (int axis = 0; axis < 3; ++axis) {
    Points above = at, below = at;
    above[moved][axis] += kStep;
    below[moved][axis] -= kStep;
    const Points high = gradientAt(above), low = gradientAt(below);
    gradientAt(at);
    for (int a = 0; a < surface.model.pointCount(); ++a)
      for (int s = surface.model.begin[a]; s < surface.model.begin[a + 1]; ++s) {
        if (a != moved && surface.model.end[s] != moved) continue;
        const int other = a == moved ? surface.model.end[s] : a;
        const SpringTangent& t = surface.workspace.tangent[s];
        const Eigen::Vector3d d = Eigen::Vector3d::Unit(axis);
        const Eigen::Vector3d expected = -(t.lateral * d + t.n * t.axial * t.n.dot(d));
        EXPECT_TRUE(((high[other] - low[other]) / (2 * kStep)).isApprox(expected, 1e-6));
      }
  }
}

TEST(SpringEnergy, NoTangentIsNegative) {
  std::mt19937 random(3);
  ElasticSurface surface(geodesicSphere(3, 1));
  prepareForRest(surface.model, surface.workspace);
  surface.workspace.trial = shaken(surface.model.rest, random, 2);
  evaluateSprings(surface.model, surface.workspace);
  for (const SpringTangent& t : surface.workspace.tangent) {
    EXPECT_GE(t.axial, 0);
    EXPECT_GE(t.lateral, 0);
    EXPECT_NEAR(t.axial + t.lateral, 100, 1e-12) << "along itself a spring is as stiff as it is";
  }
}

TEST(SpringEnergy, StoredIsThatOfSpringsAndGasAlone) {
  ElasticSurface surface = balloon(4);
  double squares = 0;
  for (const double l : surface.model.length) squares += l * l;
  Points twice = surface.model.rest;
  for (Eigen::Vector3d& p : twice) p *= 2;
  const double exact = 1e4 / 2 * squares - 100 * std::log(8.0);
  EXPECT_NEAR(storedEnergy(surface.model, surface.workspace, twice), exact, 1e-9 * exact);
  surface.workspace.trial = twice;
  EXPECT_NEAR(evaluateSprings(surface.model, surface.workspace).magnitude,
              1e4 / 2 * squares + 100 * std::log(8.0), 1e-9 * exact);
  EXPECT_NEAR(storedEnergy(surface.model, surface.workspace, surface.model.rest), 0, 1e-9);
}

TEST(SpringEnergy, VolumeIsExactFarFromTheOrigin) {
  ElasticSurface surface = balloon(4);
  Points away = surface.model.rest;
  for (Eigen::Vector3d& p : away) p += Eigen::Vector3d(100, -200, 300);
  prepareForRest(surface.model, surface.workspace);
  surface.workspace.trial = away;
  EXPECT_NEAR(evaluateSprings(surface.model, surface.workspace).volume, surface.model.restVolume, 1e-10);
}

}  // namespace
}  // namespace pleura
