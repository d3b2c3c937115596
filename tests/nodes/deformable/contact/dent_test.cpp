#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/nodes/deformable/contact/dent.h>
#include <pleura/nodes/deformable/mesh/surface_query.h>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector3i;

/// A square of 20 cm in the plane z = 0, seen from +z, of cells of `cell` metres.
struct Sheet {
  explicit Sheet(float cell) {
    const int n = static_cast<int>(0.2f / cell);
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) points.emplace_back(-0.1f + cell * i, -0.1f + cell * j, 0);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = j * (n + 1) + i;
        triangles.emplace_back(a, a + 1, a + n + 2);
        triangles.emplace_back(a, a + n + 2, a + n + 1);
      }
  }

  /// Height of the surface over (x, y).
  double heightAt(double x, double y) const {
    const SurfaceQuery query(points, triangles);
    const auto hit = query.intersectRay(Vector3d(x, y, 1), Vector3d(0, 0, -1));
    return hit ? hit->point.z() : std::nan("");
  }

  std::vector<Vector3f> points;
  std::vector<Vector3i> triangles;
};

TEST(Dent, TheProfileIsHertz) {
  EXPECT_DOUBLE_EQ(hertzProfile(0), 1);
  EXPECT_DOUBLE_EQ(hertzProfile(1), 0.5);
  EXPECT_NEAR(hertzProfile(1 + 1e-9), 0.5, 1e-6) << "inside and outside meet";
  // far away as a force at one point: u = F / (pi E* r) with F = 4/3 E* sqrt(R) d^(3/2), so u / d = 4 / (3 pi
  // rho)
  EXPECT_NEAR(hertzProfile(50) * 50, 4 / (3 * std::numbers::pi), 1e-3);
  double last = 1;
  for (double rho = 0.1; rho < 8; rho += 0.1) {
    EXPECT_LT(hertzProfile(rho), last);
    last = hertzProfile(rho);
  }
}

TEST(Dent, IsAsDeepAsTheTouchWhereverInATriangleAndHoweverFineTheMesh) {
  for (const float cell : {0.02f, 0.005f, 0.001f})
    for (const double depth : {0.0001, 0.002, 0.01})
      for (const Vector3f& at :
           {Vector3f(0, 0, 0), Vector3f(0.0007f, 0.0013f, 0), Vector3f(0.0061f, -0.0023f, 0)}) {
        Sheet sheet(cell);
        ASSERT_TRUE(
            press({.point = at, .normal = Vector3f::UnitZ(), .depth = depth}, sheet.triangles, sheet.points));
        EXPECT_NEAR(sheet.heightAt(at.x(), at.y()), -depth, 1e-6) << cell << " " << at.transpose();
      }
}

TEST(Dent, IsLocal) {
  Sheet sheet(0.001f);
  constexpr double kDepth = 0.005;
  press({.point = Vector3f::Zero(), .normal = Vector3f::UnitZ(), .depth = kDepth, .radius = 0.0025},
        sheet.triangles, sheet.points);
  const double a = std::sqrt(0.0025 * kDepth);
  EXPECT_LT(sheet.heightAt(2 * a, 0), -0.05 * kDepth);
  for (const Vector3f& p : sheet.points) {
    EXPECT_LE(p.z(), 0.0f);
    if (p.head<2>().norm() > 6 * a + 1e-6) {
      EXPECT_EQ(p.z(), 0.0f);
    }
  }
}

TEST(Dent, WhatMakesNoSenseMovesNothing) {
  const Sheet rest(0.01f);
  const Vector3f up = Vector3f::UnitZ();
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  for (const Dent& dent : {Dent{.point = Vector3f::Zero(), .normal = up, .depth = 0},
                           Dent{.point = Vector3f::Zero(), .normal = up, .depth = -1},
                           Dent{.point = Vector3f::Zero(), .normal = up, .depth = std::nan("")},
                           Dent{.point = Vector3f(kNaN, 0, 0), .normal = up, .depth = 0.01},
                           Dent{.point = Vector3f::Zero(), .normal = Vector3f(kNaN, 0, 0), .depth = 0.01},
                           Dent{.point = Vector3f(0, 0, 1), .normal = up, .depth = 0.01}}) {
    Sheet sheet = rest;
    EXPECT_FALSE(press(dent, sheet.triangles, sheet.points));
    EXPECT_EQ(sheet.points, rest.points);
  }
}

}  // namespace
}  // namespace pleura
