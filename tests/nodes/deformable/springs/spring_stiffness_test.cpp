#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "elastic_surface.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/topology.h>
#include <pleura/nodes/deformable/springs/spring_stiffness.h>

namespace pleura {
namespace {

constexpr double kModulus = 100;  // [N/m]

std::vector<double> stiffnessOf(const TriangleMesh& mesh) {
  return membraneStiffness(mesh.points, mesh.triangles, edges(mesh.points.size(), mesh.triangles), kModulus);
}

TEST(SpringStiffness, OfEquilateralTrianglesIsThatOfTheLattice) {
  // E = 2 k / sqrt(3) of the triangular lattice (Seung and Nelson 1988), inside it.
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0.5f, std::sqrt(0.75f), 0}, {0.5f, -std::sqrt(0.75f), 0}},
                    {{0, 1, 2}, {0, 3, 1}}};
  const std::vector<double> k = stiffnessOf(mesh);
  EXPECT_NEAR(k[0], std::sqrt(0.75) * kModulus, 1e-5);
  EXPECT_NEAR(k[1], std::sqrt(0.75) / 2 * kModulus, 1e-5) << "half of it at the border";
}

// Twice the energy of an even stretch e is 2 E / (1 - nu) e^2 A, nu = 1/3: that is sum k l^2 = 3 E A.
TEST(SpringStiffness, MakesAnEvenStretchAsStiffOnEveryMesh) {
  std::mt19937 random(1);
  for (const int cuts : {3, 8, 17}) {
    TriangleMesh mesh = geodesicSphere(cuts, 1);
    std::uniform_real_distribution<float> shake(-0.2f, 0.2f);
    for (Eigen::Vector3f& p : mesh.points)
      for (float& x : p) x += shake(random) / static_cast<float>(cuts);
    const ElasticSurface surface(mesh, {stiffnessOf(mesh), {0}, 0});
    double sum = 0;
    for (std::size_t s = 0; s < surface.model.length.size(); ++s)
      sum += surface.model.stiffness[s] * surface.model.length[s] * surface.model.length[s];
    const double exact = 3 * kModulus * surfaceArea(mesh.points, mesh.triangles);
    EXPECT_NEAR(sum / exact, 1, 1e-6);
  }
}

// p R / 2 = E / (1 - nu) e at small pressures, whatever the mesh; equal springs would halve e at each finer
// one.
TEST(SpringStiffness, ABalloonSwellsAsMuchOnEveryMesh) {
  for (const int cuts : {4, 8, 16}) {
    const TriangleMesh mesh = geodesicSphere(cuts, 1);
    ElasticSurface surface(mesh, {stiffnessOf(mesh), {0}, 0}, PressureInterior{0.1});
    EXPECT_TRUE(surface.solve({}, {}, {1e-9, 50, 500}).converged);
    double radius = 0;
    for (const Eigen::Vector3d& p : surface.positions)
      radius += p.norm() / static_cast<double>(mesh.points.size());
    const double strain = 0.1 / 2 / (kModulus * 1.5);
    EXPECT_NEAR((radius - 1) / strain, 1, 0.06) << cuts;
  }
}

TEST(SpringStiffness, OfSliversAndDuplicatesIsKeptInBounds) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0.5f, 1e-30f, 0}, {0, 1e-4f, 0}},
                          {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {2, 2, 4}}};
  for (const double k : stiffnessOf(mesh)) {
    EXPECT_GE(k, 1e-3 * kModulus);
    EXPECT_LE(k, 1e3 * kModulus);
  }
}

TEST(SpringStiffness, RefusesWhatIsNotSound) {
  const TriangleMesh mesh = geodesicSphere(1, 1);
  const auto pairs = edges(mesh.points.size(), mesh.triangles);
  for (const double modulus : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(membraneStiffness(mesh.points, mesh.triangles, pairs, modulus), std::invalid_argument);
  EXPECT_THROW(membraneStiffness(mesh.points, std::vector<Eigen::Vector3i>{{0, 1, 12}}, pairs, 1),
               std::invalid_argument);
}

}  // namespace
}  // namespace pleura
