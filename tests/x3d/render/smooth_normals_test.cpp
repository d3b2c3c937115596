#include "shapes.h"
#include <gtest/gtest.h>

#include <pleura/x3d/browser/render/smooth_normals.h>

namespace pleura::render::test {
namespace {

TEST(SmoothNormals, OfASpherePointOutwardsWithinADegree) {
  const Shape ball = sphere(0.1f, 64);
  std::vector<Eigen::Vector3f> normals(ball.positions.size());
  smoothNormals(ball.positions, ball.indices, normals);
  for (std::size_t i = 65; i + 65 < normals.size(); ++i) {  // the poles' many vertices have a triangle each
    const bool atSeam = i % 65 == 0 || i % 65 == 64;
    EXPECT_TRUE(atSeam || normals[i].dot(ball.normals[i]) > 0.9998f) << i;
  }
}

TEST(SmoothNormals, DegenerateTrianglesAndLooseVerticesGiveZero) {
  const std::vector<Eigen::Vector3f> positions{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}};
  const std::vector<std::uint32_t> triangles{0, 1, 2};
  std::vector<Eigen::Vector3f> normals(4, Eigen::Vector3f::Ones());
  smoothNormals(positions, triangles, normals);
  for (const Eigen::Vector3f& n : normals) EXPECT_EQ(n, Eigen::Vector3f(0, 0, 0));
}

TEST(SmoothNormals, TinyTrianglesKeepUnitNormals) {
  const std::vector<Eigen::Vector3f> positions{{0, 0, 0}, {1e-12f, 0, 0}, {0, 1e-12f, 0}};
  const std::vector<std::uint32_t> triangles{0, 1, 2};
  std::vector<Eigen::Vector3f> normals(3);
  smoothNormals(positions, triangles, normals);
  EXPECT_LE((normals[0] - Eigen::Vector3f::UnitZ()).norm(), 1e-5f);
}

}  // namespace
}  // namespace pleura::render::test
