#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/nodes/lung/planar/concentric_mesh.h>
#include <pleura/nodes/lung/planar/polygon.h>

namespace pleura::planar {
namespace {

using Eigen::Vector2d;

std::vector<Vector2d> ringOf(int count, double squeeze) {
  std::vector<Vector2d> ring;
  for (int k = 0; k < count; ++k) {
    const double a = 2 * std::numbers::pi * k / count;
    ring.emplace_back(std::cos(a), squeeze * std::sin(a));
  }
  return ring;
}

TEST(ConcentricMesh, IsEulersOfADisc) {
  for (const int rings : {1, 2, 7}) {
    const LungMesh mesh = concentricMesh(ringOf(6 * rings, 1));
    const int points = static_cast<int>(mesh.points.size());
    const int triangles = static_cast<int>(mesh.triangles.size());
    EXPECT_EQ(points, 1 + 3 * rings * (rings + 1));
    EXPECT_EQ(points - (3 * triangles + mesh.outlineCount) / 2 + triangles, 1);
  }
}

TEST(ConcentricMesh, AHexagonHasEqualTriangles) {
  std::vector<Vector2d> ring;
  const auto corners = ringOf(6, 1);
  for (std::size_t c = 0; c < 6; ++c)
    for (int k = 0; k < 4; ++k) ring.emplace_back(corners[c] + k / 4.0 * (corners[(c + 1) % 6] - corners[c]));
  const LungMesh mesh = concentricMesh(ring);
  for (const auto& t : mesh.triangles) {
    const auto p = [&](int k) { return mesh.points[static_cast<std::size_t>(t[k])]; };
    EXPECT_NEAR(cross(p(1) - p(0), p(2) - p(0)) / 2, area(ring) / 96, 1e-15);
  }
}

TEST(ConcentricMesh, WhatItCannotMeshIsRefused) {
  EXPECT_THROW(concentricMesh(std::vector<Vector2d>{}), std::invalid_argument);
  EXPECT_THROW(concentricMesh(ringOf(7, 1)), std::invalid_argument);
  EXPECT_THROW(concentricMesh(ringOf(12, -1)), std::invalid_argument) << "clockwise";
  auto folded = ringOf(18, 1);
  folded[3] = Vector2d(-0.9, -0.2);
  EXPECT_THROW(concentricMesh(folded), std::invalid_argument);
}

}  // namespace
}  // namespace pleura::planar
