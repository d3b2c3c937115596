#include <vector>

#include <gtest/gtest.h>

#include <pleura/nodes/lung/planar/hemithorax.h>
#include <pleura/nodes/lung/planar/polygon.h>

namespace pleura::planar {
namespace {

using Eigen::Vector2d;

TEST(Polygon, AreaAndCentroidOfARectangle) {
  const std::vector<Vector2d> ring{{1, 2}, {4, 2}, {4, 4}, {1, 4}};
  EXPECT_DOUBLE_EQ(area(ring), 6);
  EXPECT_NEAR((centroid(ring) - Vector2d(2.5, 3)).norm(), 0, 1e-15);
}

TEST(Polygon, UniformPressureHasNoNetForceAndIsMinusDVByDX) {
  std::vector<Vector2d> ring = makeHemithorax({}).wall.rest;
  Vector2d sum = Vector2d::Zero();
  double turning = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vector2d g = areaGradient(ring, k);
    sum += g;
    turning += cross(ring[k], g);
    // P l n of an edge, half on each of its nodes
    const Vector2d before = ring[k] - ring[(k + ring.size() - 1) % ring.size()];
    const Vector2d after = ring[(k + 1) % ring.size()] - ring[k];
    EXPECT_NEAR((g - (Vector2d(before.y(), -before.x()) + Vector2d(after.y(), -after.x())) / 2).norm(), 0,
                1e-16);
    for (int axis = 0; axis < 2; ++axis) {
      const double step = 1e-4;
      const double at = ring[k][axis];
      ring[k][axis] = at + step;
      const double more = area(ring);
      ring[k][axis] = at - step;
      const double less = area(ring);
      ring[k][axis] = at;
      EXPECT_NEAR((more - less) / (2 * step), g[axis], 1e-12);
    }
  }
  EXPECT_NEAR(sum.norm(), 0, 1e-15);
  EXPECT_NEAR(turning, 0, 1e-16);
}

}  // namespace
}  // namespace pleura::planar
