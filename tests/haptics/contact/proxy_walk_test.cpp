#include <limits>

#include "surfaces.h"
#include <gtest/gtest.h>

#include <pleura/haptics/contact/proxy.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;
using surfaces::Surface;
using surfaces::Touchable;

/// [m] that the ball may overlap a surface that stands.
constexpr double tolerance = 2e-9;

/// Of the triangles that the straight way from p to q goes through.
int crossings(const TouchShape& shape, const Vector3d& p, const Vector3d& q) {
  int count = 0;
  for (int t = 0; t < static_cast<int>(shape.mesh->triangles().size()); ++t) {
    const Corners c = cornersOf(shape, t);
    const Vector3d n = (c.col(1) - c.col(0)).cross(c.col(2) - c.col(0));
    const double before = n.dot(p - c.col(0)), after = n.dot(q - c.col(0));
    if ((before < 0) == (after < 0)) continue;
    const Vector3d at = p + before / (before - after) * (q - p);
    bool inside = true;
    for (int k = 0; k < 3; ++k)
      inside = inside && n.dot((c.col((k + 1) % 3) - c.col(k)).cross(at - c.col(k))) >= 0;
    count += inside ? 1 : 0;
  }
  return count;
}

struct Walk {
  double radius = 1e-3;
  double stride = 5e-4;  // [m] of a tick, about
  double half = 0.02;    // [m] of the cube in which the device walks
  int ticks = 2000;
  unsigned seed = 1;
  double friction = 0;
};

/// The device walks at random from a place that is clear: every now and then it turns, and sometimes jumps.
void expectNeverThrough(Touchable& touchable, const Walk& walk, const Vector3d& start) {
  std::mt19937 random(walk.seed);
  touchable.shape.surface.staticFriction = walk.friction;
  touchable.shape.surface.dynamicFriction = walk.friction / 2;
  Proxy proxy(walk.radius);
  proxy.reset(start);
  Vector3d device = start, target = start;
  double overlap = -1;
  int through = 0, touching = 0;
  for (int tick = 0; tick < walk.ticks; ++tick) {
    if (tick % 50 == 0) target = surfaces::randomPoint(random, walk.half);
    if (tick % 333 == 332) device = surfaces::randomPoint(random, walk.half);
    const Vector3d way = target - device;
    device +=
        std::min(1.0, walk.stride / std::max(way.norm(), 1e-9)) * way + surfaces::randomPoint(random, 1e-5);
    proxy.follow(std::span(&touchable.shape, 1), device);
    // through a closed surface an odd number of times is inside
    through += touchable.mesh.isClosed() ? crossings(touchable.shape, start, proxy.position()) % 2 : 0;
    overlap = std::max(overlap, walk.radius - surfaces::distanceTo(touchable.shape, proxy.position()));
    touching += proxy.contacts().empty() ? 0 : 1;
  }
  EXPECT_EQ(through, 0);
  EXPECT_LE(overlap, tolerance);
  EXPECT_GT(touching, walk.ticks / 50);
}

/// All walks over a surface.
void expectSolid(const Surface& surface, bool twoSided, const Vector3d& start) {
  Touchable touchable(surface);
  touchable.shape.surface.twoSided = twoSided;
  for (const double ball : {5e-4, 1e-3, 3e-3})
    for (const double stride : {1e-4, 5e-4, 3e-3})
      for (const double friction : {0.0, 0.5}) {
        SCOPED_TRACE(testing::Message()
                     << "radius " << ball << " stride " << stride << " friction " << friction);
        expectNeverThrough(touchable, {.radius = ball, .stride = stride, .friction = friction}, start);
      }
}

TEST(ProxyWalk, Sphere) { expectSolid(surfaces::sphere(20, 16, 0.015), false, {0, 0, 0.03}); }

TEST(ProxyWalk, BumpySphere) {
  const auto bumpy = [](const Vector3d& d) {
    return 0.013 + 0.002 * std::sin(9 * d.x()) * std::cos(8 * d.y());
  };
  expectSolid(surfaces::sphere(30, 24, bumpy), false, {0, 0, 0.03});
}

TEST(ProxyWalk, Box) { expectSolid(surfaces::box({0.01, 0.006, 0.012}), false, {0, 0, 0.03}); }

TEST(ProxyWalk, BoxOfManySquares) {
  expectSolid(surfaces::box({0.01, 0.006, 0.012}, 8), false, {0, 0, 0.03});
}

TEST(ProxyWalk, ThinBox) { expectSolid(surfaces::box({0.015, 0.015, 1e-4}, 4), false, {0, 0, 0.03}); }

TEST(ProxyWalk, InsideABox) {
  Surface surface = surfaces::box({0.01, 0.012, 0.014}, 3);
  for (Eigen::Vector3i& t : surface.triangles) std::swap(t[1], t[2]);
  expectSolid(surface, false, {0, 0, 0});
}

TEST(ProxyWalk, TwoSidedSheet) {
  expectSolid(surfaces::sheet(0.01, 1, [](double, double) { return 0; }), true, {0, 0, 0.03});
  expectSolid(surfaces::sheet(0.01, 6, [](double, double) { return 0; }), true, {0, 0, 0.03});
}

TEST(ProxyWalk, TwoSidedSaddle) {
  expectSolid(surfaces::sheet(0.012, 10, [](double x, double y) { return 40 * (x * x - y * y); }), true,
              {0, 0, 0.03});
}

TEST(ProxyWalk, TwoSidedValley) {
  expectSolid(surfaces::sheet(0.012, 4, [](double x, double) { return 2 * std::abs(x) - 0.01; }), true,
              {0, 0, 0.03});
}

}  // namespace
}  // namespace pleura::haptics
