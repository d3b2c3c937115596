#include <cmath>
#include <numbers>

#include "solid_bodies.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/linear_solid.h>

namespace pleura {
namespace {

// How far the tip (1, 0, 0) of the clamped cube sinks [m] under 1 kg: spread over its nodes alike, or over
// its volume.
enum class Load { nodesAlike, volume };

double sagOfCube(int n, int nodesPerElement, Load load) {
  const SolidMesh mesh = cube(n, nodesPerElement);
  LinearSolid solid(mesh, softCube(), {clampedFace(mesh), {}});
  EXPECT_EQ(solid.degenerateCount(), 0);
  NodeVectors forces = weights(solid.body().mass, {0, 0, -9.81});
  if (load == Load::nodesAlike)
    forces.assign(forces.size(), Eigen::Vector3d(0, 0, -9.81 / static_cast<double>(forces.size())));
  const SolidReport report = solid.step(kStatic, {.forces = forces});
  EXPECT_TRUE(report.converged());
  EXPECT_LT(report.residual, 1e-9);
  return -solid.state().position[n].z();
}

TEST(LinearSolid, CubeSinksUnderItsOwnWeight) {
  EXPECT_NEAR(sagOfCube(10, 4, Load::nodesAlike), 0.001434, 0.003 * 0.001434);
  EXPECT_NEAR(sagOfCube(16, 4, Load::nodesAlike), 0.001447, 0.003 * 0.001447);
}

// Extrapolated from three meshes each, tetrahedra and hexahedra, the two ways of loading agree.
double limitOfSag(int nodesPerElement, Load load) {
  const double a = sagOfCube(4, nodesPerElement, load), b = sagOfCube(8, nodesPerElement, load),
               c = sagOfCube(16, nodesPerElement, load);
  return c - (c - b) * (c - b) / ((c - b) - (b - a));  // Aitken
}

TEST(LinearSolid, CubeConvergesWithTheMesh) {
  const double limit = limitOfSag(8, Load::volume);
  EXPECT_GT(limit, 0.00143);
  EXPECT_LT(limit, 0.00146);
  EXPECT_NEAR(limitOfSag(4, Load::volume), limit, 0.01 * limit);
  EXPECT_NEAR(limitOfSag(4, Load::nodesAlike), limit, 0.01 * limit);
}

// Timoshenko's cantilever, 10 x 1 x 1 m, a force at its tip: F L^3 / 3 E I + F L / kappa G A.
TEST(LinearSolid, CantileverBendsAsABeam) {
  const double E = 1e6, nu = 0, L = 10, F = 1;
  const SolidMesh mesh = box({80, 8, 8}, {L, 1, 1}, 8);
  LinearSolid solid(mesh, {.density = 1, .youngsModulus = E, .poissonRatio = nu}, {clampedFace(mesh), {}});
  NodeVectors forces(mesh.nodes.size(), Eigen::Vector3d::Zero());
  for (int cell = 0; cell < 64; ++cell)  // evenly over the face x = L
    for (int corner = 0; corner < 4; ++corner)
      forces[80 + 81 * ((cell % 8 + corner % 2) + 9 * (cell / 8 + corner / 2))].z() -= F / 256;
  ASSERT_TRUE(solid.step(kStatic, {.forces = forces}).converged());
  const double expected = F * L * L * L / (3 * E / 12) + F * L / (5. / 6 * E / 2);
  EXPECT_NEAR(0.5 - solid.state().position[80 + 81 * (4 + 9 * 4)].z(), expected, 0.01 * expected);
}

// Errors in L2 against a made-up field u, its load found from it: of order 2 in the mesh size.
double errorOfMadeUpField(int n, int nodesPerElement) {
  SolidMesh mesh = cube(n, nodesPerElement);
  const auto surface = nodesWhere(mesh, [](const auto& x) { return x.minCoeff() <= 0 || x.maxCoeff() >= 1; });
  const double E = 1, nu = 0.3, pi = std::numbers::pi;
  LinearSolid solid(mesh, {.density = 1, .youngsModulus = E, .poissonRatio = nu}, {surface, {}});
  const auto [lambda, mu] = solid.body().lame;
  // u = (s, 0, 0), s = sin(pi x) sin(pi y) sin(pi z): -div sigma = -(lambda + mu) grad(s_x) - mu laplace(s)
  // e_x.
  NodeVectors forces;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Eigen::Array3d s = (pi * mesh.nodes[i].array()).sin(), c = (pi * mesh.nodes[i].array()).cos();
    const Eigen::Vector3d grad(-s[0] * s[1] * s[2], c[0] * c[1] * s[2], c[0] * s[1] * c[2]);
    forces.push_back(solid.body().mass[i] * pi * pi *
                     (-(lambda + mu) * grad + Eigen::Vector3d(3 * mu * s.prod(), 0, 0)));
  }
  EXPECT_TRUE(solid.step(kStatic, {.forces = forces}).converged());
  double sum = 0;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Eigen::Vector3d u((pi * mesh.nodes[i].array()).sin().prod(), 0, 0);
    sum += solid.body().mass[i] * (solid.state().position[i] - mesh.nodes[i] - u).squaredNorm();
  }
  return std::sqrt(sum);
}

TEST(LinearSolid, SecondOrderInTheMeshSize) {
  for (const int kind : {4, 8})
    EXPECT_NEAR(std::log2(errorOfMadeUpField(6, kind) / errorOfMadeUpField(12, kind)), 2, 0.2) << kind;
}

TEST(LinearSolid, StiffnessIsSymmetricAndKnowsRigidMotion) {
  for (const int kind : {4, 8}) {
    SolidMesh mesh = cube(2, kind);
    distort(mesh, 0.1);
    LinearSolid solid(mesh, softCube(), {});
    const BlockPattern& pattern = solid.body().pattern;
    for (int i = 0; i < pattern.rowCount(); ++i) {
      const Eigen::Matrix3d& block = solid.stiffness()[pattern.begin[i]];
      EXPECT_LT((block - block.transpose()).norm(), 1e-14 * block.norm());
    }
    for (int mode = 0; mode < 6; ++mode) {
      NodeVectors x, y(mesh.nodes.size());
      for (const auto& X : mesh.nodes)
        x.push_back(mode < 3 ? Eigen::Vector3d(Eigen::Vector3d::Unit(mode))
                             : Eigen::Vector3d::Unit(mode - 3).cross(X));
      multiply(pattern, solid.stiffness(), x, y);
      EXPECT_LT(flat(y).norm(), 1e-10);
    }
  }
}

// Hexahedra of a nearly incompressible clamped cube keep their sag. (Tetrahedra lock: at nu = 0.4999 and 12
// cells they sink by 0.00106 m instead of 0.00141.)
TEST(LinearSolid, HexahedraDoNotLock) {
  const auto sag = [](int n, int kind, double nu) {
    const SolidMesh mesh = cube(n, kind);
    SolidMaterial material = softCube();
    material.poissonRatio = nu;
    LinearSolid solid(mesh, material, {clampedFace(mesh), {}});
    const NodeVectors forces = weights(solid.body().mass, {0, 0, -9.81});
    EXPECT_TRUE(solid.step(kStatic, {.forces = forces}).converged());
    return -solid.state().position[n].z();
  };
  for (const double nu : {0.49, 0.499, 0.4999}) {
    const double fine = sag(12, 8, nu);
    EXPECT_NEAR(sag(6, 8, nu), fine, 0.04 * fine) << nu;
    EXPECT_NEAR(fine, sag(12, 8, 0.49), 0.03 * fine) << nu;
  }
}

// A thick spherical shell under pressure inside (Lame): u(r) = p a^3 / (E (b^3 - a^3)) ((1 - 2 nu) r +
// (1 + nu) b^3 / 2 r^2). A patch of it, the exact displacement prescribed where it is cut.
TEST(LinearSolid, ThickShellUnderPressure) {
  const double a = 1, b = 2, p = 1, E = 1000;
  for (const double nu : {0.3, 0.4999}) {
    const int n = 10;
    SolidMesh mesh = cube(n, 8);
    // x, y: across the patch |tan| <= tan(pi/8) of the sphere around +z; z: along the radius.
    for (auto& X : mesh.nodes) {
      const double s = std::tan((X.x() - 0.5) * std::numbers::pi / 4),
                   t = std::tan((X.y() - 0.5) * std::numbers::pi / 4);
      X = (a + (b - a) * X.z()) * Eigen::Vector3d(s, t, 1).normalized();
    }
    const auto exact = [&](const Eigen::Vector3d& X) -> Eigen::Vector3d {
      const double r = X.norm(), b3 = b * b * b;
      return X / r * p * a * a * a / (E * (b3 - a * a * a)) *
             ((1 - 2 * nu) * r + (1 + nu) * b3 / (2 * r * r));
    };
    std::vector<int> sides;
    NodeVectors prescribed;
    NodeVectors forces(mesh.nodes.size(), Eigen::Vector3d::Zero());
    const auto at = [&](int i, int j) { return i + (n + 1) * j; };
    for (int k = 0; k <= n; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
          if (i == 0 || i == n || j == 0 || j == n) {
            sides.push_back(at(i, j) + (n + 1) * (n + 1) * k);
            prescribed.push_back(mesh.nodes[sides.back()] + exact(mesh.nodes[sides.back()]));
          }
    for (int j = 0; j < n; ++j)  // the inner surface, two triangles a face
      for (int i = 0; i < n; ++i)
        for (const auto& [u, v, w] : {std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                                      std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)}}) {
          const Eigen::Vector3d area =
              0.5 * (mesh.nodes[v] - mesh.nodes[u]).cross(mesh.nodes[w] - mesh.nodes[u]);
          for (const int node : {u, v, w}) forces[node] += p / 3 * area;
        }
    LinearSolid solid(mesh, {.density = 1, .youngsModulus = E, .poissonRatio = nu}, {sides, {}});
    ASSERT_TRUE(solid.step(kStatic, {.forces = forces, .prescribed = prescribed}).converged());
    double most = 0, size = 0;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      most = std::max(most, (solid.state().position[i] - mesh.nodes[i] - exact(mesh.nodes[i])).norm());
      size = std::max(size, exact(mesh.nodes[i]).norm());
    }
    EXPECT_LT(most, 0.01 * size) << nu;
  }
}

// What was factorised serves any prescribed displacement, and the answers are linear in it.
TEST(LinearSolid, PrescribedDisplacementsChange) {
  const SolidMesh mesh = cube(3, 4);
  LinearSolid solid(mesh, softCube(), {clampedFace(mesh), {}});
  NodeVectors once, twice;
  for (const int i : clampedFace(mesh)) {
    once.push_back(mesh.nodes[i] + Eigen::Vector3d(0, 0.1 * mesh.nodes[i].z(), 0));
    twice.push_back(mesh.nodes[i] + Eigen::Vector3d(0, 0.2 * mesh.nodes[i].z(), 0));
  }
  ASSERT_TRUE(solid.step(kStatic, {.prescribed = once}).converged());
  const NodeVectors half = solid.state().position;
  ASSERT_TRUE(solid.step(kStatic, {.prescribed = twice}).converged());
  for (std::size_t i = 0; i < half.size(); ++i)
    EXPECT_LT((solid.state().position[i] - mesh.nodes[i] - 2 * (half[i] - mesh.nodes[i])).norm(), 1e-12);
  EXPECT_GT((half[3] - mesh.nodes[3]).norm(), 0.01);
}

// From any state whatever a static step is back at rest, the energy being quadratic.
TEST(LinearSolid, RecoversFromAnything) {
  const SolidMesh mesh = cube(3, 4);
  LinearSolid solid(mesh, softCube(), {clampedFace(mesh), {}});
  SolidState state = solid.state();
  std::shuffle(state.position.begin(), state.position.end(), std::mt19937(2));
  for (const int i : clampedFace(mesh)) state.position[i] = mesh.nodes[i];
  ASSERT_TRUE(solid.setState(state));
  EXPECT_TRUE(solid.step(kStatic, {}).converged());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    EXPECT_LT((solid.state().position[i] - mesh.nodes[i]).norm(), 1e-9);
}

}  // namespace
}  // namespace pleura
