#include "bodies.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/embedding.h>

namespace pleura {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3f;

std::vector<Vector3d> interpolated(const Embedding& embedding, const std::vector<Vector3d>& nodes) {
  std::vector<Vector3d> points(embedding.size());
  interpolate(embedding, nodes, points);
  return points;
}

std::vector<Vector3d> randomVectors(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Vector3d> vectors(count);
  for (Vector3d& v : vectors) v = shapes::randomPoint(random);
  return vectors;
}

TEST(Embedding, ReproducesTheRestShapeToRounding) {
  for (const double offset : {0.0, 100.0}) {
    for (const auto& [name, body] : bodies::sound()) {
      const TriangleMesh mesh = bodies::placed(body, Vector3d::Constant(offset));
      const Lattice lattice = makeLattice(mesh, {.elements = 1000});
      const Embedding embedding = embed(lattice, mesh.points);
      EXPECT_EQ(embedding.outside, 0) << name;
      const auto points = interpolated(embedding, lattice.solid.nodes);
      for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_LT((points[i] - mesh.points[i].cast<double>()).norm(), 1e-15 * (10 + 10 * offset)) << name;
    }
  }
}

TEST(Embedding, FollowsEveryAffineMotion) {
  const TriangleMesh mesh = shapes::torus(40, 20);
  const Lattice lattice = makeLattice(mesh, {.elements = 500});
  const Embedding embedding = embed(lattice, mesh.points);
  Matrix3d f;
  f << 1.2, 0.3, -0.1, 0.2, 0.7, 0.4, -0.3, 0.1, 1.5;
  std::vector<Vector3d> nodes = lattice.solid.nodes;
  for (Vector3d& node : nodes) node = f * node + Vector3d(1, 2, 3);
  const auto points = interpolated(embedding, nodes);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LT((points[i] - f * mesh.points[i].cast<double>() - Vector3d(1, 2, 3)).norm(), 1e-14);
}

TEST(Embedding, TransposedKeepsForceMomentAndPower) {
  const TriangleMesh mesh = shapes::torus(40, 20);
  const Lattice lattice = makeLattice(mesh, {.elements = 500});
  const Embedding embedding = embed(lattice, mesh.points);
  std::vector<Vector3d> nodes = lattice.solid.nodes;  // deformed at random
  const auto shifts = randomVectors(nodes.size(), 1), velocities = randomVectors(nodes.size(), 2);
  for (std::size_t a = 0; a < nodes.size(); ++a) nodes[a] += 0.1 * shifts[a];
  const auto points = interpolated(embedding, nodes), pointVelocities = interpolated(embedding, velocities);
  const auto forces = randomVectors(points.size(), 3);
  std::vector<Vector3d> nodeForces(nodes.size(), Vector3d::Zero());
  addTransposed(embedding, forces, nodeForces);
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  double power = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    force += forces[i];
    moment += points[i].cross(forces[i]);
    power += pointVelocities[i].dot(forces[i]);
  }
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    force -= nodeForces[a];
    moment -= nodes[a].cross(nodeForces[a]);
    power -= velocities[a].dot(nodeForces[a]);
  }
  EXPECT_LT(force.norm(), 1e-11);
  EXPECT_LT(moment.norm(), 1e-11);
  EXPECT_LT(std::abs(power), 1e-11);
}

TEST(Embedding, OfPartsApartTiesEachPointToItsOwn) {
  const TriangleMesh cube = shapes::cube();
  const TriangleMesh mesh = bodies::together(cube, bodies::placed(cube, {1.3, 0, 0}));
  const Lattice lattice = makeLattice(mesh, {.cellSize = 0.1});
  const Embedding embedding = embed(lattice, mesh.points);
  EXPECT_EQ(embedding.outside, 0);
  ASSERT_EQ(lattice.report.bodies, 2);
  std::vector<Vector3d> nodes = lattice.solid.nodes;
  for (Vector3d& node : nodes) node.x() += node.x() > 1.15 ? 5 : 0;
  const auto points = interpolated(embedding, nodes);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(points[i].x() - mesh.points[i].x(), i < 8 ? 0 : 5, 1e-12) << i;
}

TEST(Embedding, ExtrapolatesPointsOutside) {
  const Lattice lattice = makeLattice(shapes::sphere(24), {.elements = 500});
  const std::vector<Vector3f> points = {{0, 0, 1.5f}, {-30, 2, 1}, {0.99f, 0.99f, 0.99f}, {0, 0, 0}};
  const Embedding embedding = embed(lattice, points);
  EXPECT_EQ(embedding.outside, 3);
  const auto found = interpolated(embedding, lattice.solid.nodes);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LT((found[i] - points[i].cast<double>()).norm(), 1e-9);
  const auto distance = [&](std::size_t point, int element) {
    const Vector3d low = lattice.solid.nodes[lattice.solid.elements[8 * element]];
    return (low.array() + lattice.grid.cellSize / 2 - points[point].cast<double>().array()).matrix().norm();
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    double least = distance(i, 0);
    for (int e = 1; e < lattice.solid.elementCount(); ++e) least = std::min(least, distance(i, e));
    EXPECT_LT(distance(i, embedding.elements[i]), least + 2 * lattice.grid.cellSize) << "tied to one near by";
  }
  EXPECT_THROW(embed(lattice, std::vector<Vector3f>{{0, 0, std::nanf("")}}), std::invalid_argument);
  EXPECT_THROW(embed(Lattice{}, points), std::invalid_argument);
}

}  // namespace
}  // namespace pleura
