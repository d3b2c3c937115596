#include <limits>

#include "ring_cage.h"
#include <gtest/gtest.h>

#include <pleura/nodes/thorax/motion/pleural_wall.h>

namespace pleura {
namespace {

/// Points of the wall between the first and the last ring, where it is a cylinder.
template <class Check>
void forCylinder(const PleuralWall& wall, Check check) {
  for (std::size_t k = 0; k < wall.rest.size(); ++k) {
    if (std::abs(wall.rest[k].y()) < 0.075f) check(k);
  }
}

TEST(PleuralWall, TouchesTheRingsFromInsideAndBridgesTheSpaces) {
  const RingCage cage;
  int count = 0;
  forCylinder(cage.wall, [&](std::size_t k) {
    const float radius = std::hypot(cage.wall.rest[k].x(), cage.wall.rest[k].z());
    EXPECT_GT(radius, 0.0940f);
    EXPECT_LT(radius, 0.0975f);  // 95 mm and the bulge of a 20 mm gap
    ++count;
  });
  EXPECT_GT(count, 1000);
}

TEST(PleuralWall, NormalsPointIntoTheCavity) {
  const RingCage cage;
  forCylinder(cage.wall, [&](std::size_t k) {
    const Eigen::Vector3f n = cage.wall.inward[k].head<3>();
    EXPECT_NEAR(n.norm(), 1.0f, 1e-5f);
    EXPECT_LT(n.dot(Eigen::Vector3f(cage.wall.rest[k].x(), 0.0f, cage.wall.rest[k].z()).normalized()), -0.8f);
  });
  const auto triangles = wallTriangles(cage.wall);
  for (const Eigen::Vector3i& t : triangles) {
    const auto p = [&](int i) -> Eigen::Vector3f {
      return cage.wall.rest[static_cast<std::size_t>(t[i])].head<3>();
    };
    if (std::abs(p(0).y()) > 0.07f) continue;
    EXPECT_LT((p(1) - p(0)).cross(p(2) - p(0)).dot(Eigen::Vector3f(p(0).x(), 0.0f, p(0).z())), 0.0f);
  }
}

TEST(PleuralWall, NormalsPointIntoTheCavityAlsoWhereColumnsEndAtDifferentHeights) {
  RingCage cage;
  for (TriangleMesh* ring : {&cage.rings[4], &cage.rings[5]}) {  // the lowest rings keep their left half
    std::erase_if(ring->triangles, [&](const Eigen::Vector3i& t) {
      return ring->points[static_cast<std::size_t>(t[0])].x() < 0.0f;
    });
  }
  const auto axis = hemithoraxAxis({0.0, -0.1, 0.0}, {0.0, 0.1, 0.0}, 1.0);
  const PleuralWall wall = buildPleuralWall(axis, cage.bodies, 0.11);
  for (std::size_t k = 0; k < wall.rest.size(); ++k) {
    if (std::abs(wall.rest[k].y()) > 0.04f) continue;
    const Eigen::Vector3f out(wall.rest[k].x(), 0.0f, wall.rest[k].z());
    EXPECT_LT(wall.inward[k].head<3>().dot(out.normalized()), -0.8f) << wall.rest[k].transpose();
  }
}

TEST(PleuralWall, IsCarriedByTheRingsItTouches) {
  const RingCage cage;
  std::vector<Eigen::Vector4f> now = cage.wall.rest;
  moveWall(cage.wall, RingCage::lifted(0.0f), now);
  EXPECT_EQ(now, cage.wall.rest);
  moveWall(cage.wall, RingCage::lifted(0.02f), now);
  forCylinder(cage.wall, [&](std::size_t k) {
    EXPECT_LT((now[k] - cage.wall.rest[k] - Eigen::Vector4f(0.0f, 0.02f, 0.0f, 0.0f)).norm(), 1e-6f);
  });
  // One ring alone carries what lies on it and nothing beyond its neighbours.
  auto third = RingCage::lifted(0.0f);
  third[2](1, 3) = 0.01f;
  moveWall(cage.wall, third, now);
  forCylinder(cage.wall, [&](std::size_t k) {
    const float away = std::abs(cage.wall.rest[k].y() - RingCage::heightOf(2));
    const float moved = (now[k] - cage.wall.rest[k]).norm();
    if (away < 0.001f) {
      EXPECT_NEAR(moved, 0.01f, 1e-4f);
    }
    if (away > RingCage::kApart) {
      EXPECT_EQ(moved, 0.0f);
    }
  });
}

TEST(PleuralWall, AzimuthGrowsFromLateralToTheFrontOnBothSides) {
  for (const double side : {1.0, -1.0}) {
    const HemithoraxAxis axis = hemithoraxAxis({side * 0.07, -0.1, 0.0}, {side * 0.04, 0.15, 0.0}, side);
    EXPECT_NEAR(axis.coordinates(axis.origin + Eigen::Vector3d(side * 0.05, 0.0, 0.0)).azimuth, 0.0, 1e-9);
    EXPECT_GT(axis.coordinates(axis.origin + Eigen::Vector3d(0.0, 0.0, 0.05)).azimuth, 1.5);
    EXPECT_LT(axis.coordinates(axis.origin - Eigen::Vector3d(0.0, 0.0, 0.05)).azimuth, -1.5);
  }
}

TEST(PleuralWall, RefusesWhatDoesNotFit) {
  EXPECT_THROW(hemithoraxAxis({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1.0), std::invalid_argument);
  EXPECT_THROW(hemithoraxAxis({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.5), std::invalid_argument);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(hemithoraxAxis({0.0, 0.0, 0.0}, {0.0, infinity, 0.0}, 1.0), std::invalid_argument);
  RingCage cage;
  cage.bodies[1].weights.pop_back();
  EXPECT_THROW(buildPleuralWall(cage.wall.axis, cage.bodies, 0.11), std::invalid_argument);
}

}  // namespace
}  // namespace pleura
