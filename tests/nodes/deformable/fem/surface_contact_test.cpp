#include <algorithm>

#include "bodies.h"
#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/surface_contact.h>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// The inside of a sphere about the origin, as points see it.
struct SphereWall {
  SphereWall(const std::vector<Vector3d>& points, double radius) {
    for (const Vector3d& x : points) {
      normals.push_back(x.normalized());
      places.push_back(radius * x.normalized());
    }
  }
  ContactWall wall() const { return {places, normals}; }
  std::vector<Vector3d> places, normals;
};

/// A plane, seen from any place.
struct PlaneWall {
  PlaneWall(std::size_t points, const Vector3d& place, const Vector3d& normal)
      : places(points, place), normals(points, normal) {}
  ContactWall wall() const { return {places, normals}; }
  std::vector<Vector3d> places, normals;
};

std::vector<Vector3d> cloud(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Vector3d> points(count);
  for (Vector3d& point : points) point = shapes::randomPoint(random);
  return points;
}

TEST(SurfaceContact, PushesBackWhatIsThroughAPlaneAndNothingElse) {
  const Vector3d normal = Vector3d(1, 2, 2) / 3;
  const auto points = cloud(200, 1);
  const PlaneWall plane(points.size(), 0.2 * normal, normal);
  std::vector<Vector3d> forces(points.size(), Vector3d::Zero());
  const int contacts = addContactForces(plane.wall(), 300, points, forces);
  int through = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double depth = points[i].dot(normal) - 0.2;
    through += depth > 0 ? 1 : 0;
    EXPECT_LT((forces[i] + 300 * std::max(depth, 0.0) * normal).norm(), 1e-12);
  }
  EXPECT_EQ(contacts, through);
  EXPECT_GT(contacts, 20);
  EXPECT_LT(contacts, 180);
}

TEST(SurfaceContact, IsRadialInASphereAndTheSlopeOfItsEnergy) {
  auto points = cloud(100, 2);
  const SphereWall sphere(points, 0.8);
  const auto energy = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      sum += 150 * std::pow(std::min(sphere.wall().gap(i, points[i]), 0.0), 2);
    return sum;
  };
  std::vector<Vector3d> forces(points.size(), Vector3d::Zero());
  addContactForces(sphere.wall(), 300, points, forces);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(forces[i].dot(points[i].normalized()), -300 * std::max(points[i].norm() - 0.8, 0.0), 1e-12);
    for (int axis = 0; axis < 3; ++axis) {
      const double at = points[i][axis], step = 1e-6;
      points[i][axis] = at + step;
      const double above = energy();
      points[i][axis] = at - step;
      const double below = energy();
      points[i][axis] = at;
      EXPECT_NEAR(forces[i][axis], -(above - below) / (2 * step), 1e-5);
    }
  }
}

/// A body on springs of 1 N/m from each node to its place at rest, its points held in the wall by soft
/// constraints of stiffness k: the nodes where the active set comes to rest.
struct Settled {
  std::vector<Vector3d> nodes, points;
  std::vector<char> active;
  int solves = 0;
};

Settled settle(const Lattice& lattice, const Embedding& embedding, const ContactWall& wall,
               double stiffness) {
  const auto& rest = lattice.solid.nodes;
  const int size = 3 * static_cast<int>(rest.size());
  VectorXd atRest(size);
  for (std::size_t a = 0; a < rest.size(); ++a) atRest.segment<3>(3 * static_cast<int>(a)) = rest[a];
  Settled result{rest, std::vector<Vector3d>(embedding.size()), std::vector<char>(embedding.size(), 0)};
  interpolate(embedding, result.nodes, result.points);
  while (updateActive(wall, result.points, result.active) > 0 && result.solves < 30) {
    const ContactRows contact = contactRows(wall, embedding, result.active);
    Eigen::SparseMatrix<double> system = stiffness * contact.rows.transpose() * contact.rows;
    for (int i = 0; i < size; ++i) system.coeffRef(i, i) += 1;
    const VectorXd force = atRest + stiffness * (contact.rows.transpose() * contact.values);
    const VectorXd x = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(system).solve(force);
    for (std::size_t a = 0; a < rest.size(); ++a) result.nodes[a] = x.segment<3>(3 * static_cast<int>(a));
    interpolate(embedding, result.nodes, result.points);
    ++result.solves;
  }
  return result;
}

/// The penalty's forces of the settled body balance its springs.
void expectBalance(const Settled& settled, const Lattice& lattice, const Embedding& embedding,
                   const ContactWall& wall, double stiffness) {
  std::vector<Vector3d> forces(settled.points.size(), Vector3d::Zero());
  addContactForces(wall, stiffness, settled.points, forces);
  std::vector<Vector3d> nodeForces(settled.nodes.size(), Vector3d::Zero());
  addTransposed(embedding, forces, nodeForces);
  for (std::size_t a = 0; a < settled.nodes.size(); ++a)
    EXPECT_LT((nodeForces[a] + lattice.solid.nodes[a] - settled.nodes[a]).norm(), 1e-8);
}

TEST(SurfaceContact, ActiveSetSettlesABodyAgainstAPlane) {
  const TriangleMesh mesh = shapes::sphere(24);
  const Lattice lattice = makeLattice(mesh, {.elements = 200});
  const Embedding embedding = embed(lattice, mesh.points);
  const Vector3d normal = Vector3d(1, 2, 2) / 3;
  const PlaneWall plane(mesh.points.size(), 0.7 * normal, normal);
  const Settled settled = settle(lattice, embedding, plane.wall(), 1e4);
  EXPECT_LT(settled.solves, 30);
  EXPECT_GT(std::ranges::count(settled.active, 1), 5);
  expectBalance(settled, lattice, embedding, plane.wall(), 1e4);
  for (const Vector3d& x : settled.points) EXPECT_LT(x.dot(normal), 0.701);
  for (std::size_t a = 0; a < settled.nodes.size(); ++a)  // frictionless
    EXPECT_LT((settled.nodes[a] - lattice.solid.nodes[a]).cross(normal).norm(), 1e-8);
}

TEST(SurfaceContact, ActiveSetFitsABodyIntoASphere) {
  const TriangleMesh mesh =
      bodies::placed(shapes::sphere(24), Vector3d::Zero(), Vector3d(1.2, 1, 0.8).asDiagonal());
  const Lattice lattice = makeLattice(mesh, {.elements = 200});
  const Embedding embedding = embed(lattice, mesh.points);
  std::vector<Vector3d> points;
  for (const Eigen::Vector3f& point : mesh.points) points.push_back(point.cast<double>());
  const SphereWall sphere(points, 1.0);
  const Settled settled = settle(lattice, embedding, sphere.wall(), 1e4);
  EXPECT_LT(settled.solves, 30);
  EXPECT_GT(std::ranges::count(settled.active, 1), 20);
  EXPECT_LT(std::ranges::count(settled.active, 1), std::ssize(points) - 20);
  expectBalance(settled, lattice, embedding, sphere.wall(), 1e4);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_GT(sphere.wall().gap(i, settled.points[i]), -1e-3);
}

TEST(SurfaceContact, LetsGoOfWhatLeaves) {
  const std::vector<Vector3d> points = {{0, 0, 0.9}, {0, 0, 1.1}, {0, 0, 1}};
  const PlaneWall plane(3, {0, 0, 1}, Vector3d::UnitZ());
  std::vector<char> active = {1, 0, 1};
  EXPECT_EQ(updateActive(plane.wall(), points, active), 3);
  EXPECT_EQ(active, (std::vector<char>{0, 1, 0}));
  EXPECT_EQ(updateActive(plane.wall(), points, active), 0);
}

}  // namespace
}  // namespace pleura
