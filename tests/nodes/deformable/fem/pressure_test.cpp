#include "bodies.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/pressure.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

/// A torus, dented at random.
struct Dented {
  Dented() : triangles(shapes::torus(12, 8).triangles) {
    std::mt19937 random(11);
    for (const Eigen::Vector3f& point : shapes::torus(12, 8).points)
      points.push_back(point.cast<double>() + 0.1 * shapes::randomPoint(random));
  }
  std::vector<Vector3d> forces(double pressure) const {
    std::vector<Vector3d> result(points.size(), Vector3d::Zero());
    addPressureForces(pressure, points, triangles, result);
    return result;
  }
  std::vector<Vector3d> points;
  std::vector<Eigen::Vector3i> triangles;
};

TEST(Pressure, IsPTimesTheChangeOfVolume) {
  Dented body;
  const double pressure = 500, step = 1e-5;
  const auto forces = body.forces(pressure);
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      double& x = body.points[i][axis];
      const double at = x;
      x = at + step;
      const double above = signedVolume(body.points, body.triangles);
      x = at - step;
      const double below = signedVolume(body.points, body.triangles);
      x = at;
      // V is of first order in each coordinate: the difference is exact but for rounding.
      EXPECT_NEAR(forces[i][axis], pressure * (above - below) / (2 * step), 1e-7);
    }
  }
}

TEST(Pressure, HasNoNetForceAndNoNetMomentOnAClosedSurface) {
  const Dented body;
  const auto forces = body.forces(500);
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  double size = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    force += forces[i];
    moment += body.points[i].cross(forces[i]);
    size += forces[i].norm();
  }
  EXPECT_GT(size, 100);
  EXPECT_LT(force.norm(), 1e-14 * size);
  EXPECT_LT(moment.norm(), 1e-14 * size);
}

TEST(Pressure, AddsAThirdOfTheTrianglesForceToEachCorner) {
  const std::vector<Vector3d> points = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {9, 9, 9}};
  const std::vector<Eigen::Vector3i> triangles = {{0, 1, 2}};
  std::vector<Vector3d> forces(4, Vector3d::Ones());
  addPressureForces(10, points, triangles, forces);
  for (int i = 0; i < 3; ++i) EXPECT_LT((forces[i] - Vector3d(1, 1, 11)).norm(), 1e-14);
  EXPECT_EQ(forces[3], Vector3d(1, 1, 1));
}

TEST(Pressure, AndVolumeKeepTheirDigitsFarFromTheOrigin) {
  Dented body;
  const double volume = signedVolume(body.points, body.triangles);
  const auto before = body.forces(1);
  for (Vector3d& point : body.points) point += Vector3d(1000, -1000, 500);
  EXPECT_NEAR(signedVolume(body.points, body.triangles), volume, 1e-11 * volume);
  const auto after = body.forces(1);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_LT((before[i] - after[i]).norm(), 1e-12);
}

}  // namespace
}  // namespace pleura
