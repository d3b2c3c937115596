#include <limits>

#include "surfaces.h"
#include <gtest/gtest.h>

#include <pleura/haptics/contact/proxy.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using surfaces::Surface;
using surfaces::Touchable;

constexpr double radius = 1e-3;

void follow(Proxy& proxy, const Touchable& touchable, const Vector3d& device) {
  proxy.follow(std::span(&touchable.shape, 1), device);
}

TEST(Proxy, GoesWithTheDeviceWhereNothingIs) {
  Proxy proxy(radius);
  const Touchable sphere(surfaces::sphere(60, 50, 0.05));
  proxy.reset({0, 0, 0.2});
  for (const Vector3d& device : {Vector3d(0, 0, 0.1), Vector3d(1, 2, 3), Vector3d(0.06, 0, 0)}) {
    follow(proxy, sphere, device);
    EXPECT_EQ(proxy.position(), device);
    EXPECT_TRUE(proxy.contacts().empty());
  }
}

TEST(Proxy, RestsOnTheNearestPlaceOfASphere) {
  Proxy proxy(radius);
  const Touchable sphere(surfaces::sphere(60, 50, 0.05));
  proxy.reset({0, 0, 0.2});
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const Vector3d device = surfaces::randomPoint(random, 1).normalized() * 0.045;
    proxy.reset(device * 1.5);
    for (int k = 0; k < 8; ++k) follow(proxy, sphere, device);
    const double gap = surfaces::distanceTo(sphere.shape, proxy.position()) - radius;
    EXPECT_NEAR(gap, 0, 1e-7);
    EXPECT_FALSE(proxy.contacts().empty());
    EXPECT_LT((proxy.position().normalized() - device.normalized()).norm(), 0.1);
  }
}

/// Sixty frames of 33 ticks, each `perFrame` [m] larger than the one before; the device stays 1 mm inside of
/// where the surface was or, if it follows, is.
void expectNeverLost(double perFrame, bool follows) {
  constexpr int frames = 60, ticks = 33;
  const Surface surface = surfaces::sphere(60, 50, 0.05);
  Touchable sphere(surface);
  const Vector3d direction = Vector3d(1, 2, 3).normalized();
  Proxy proxy(radius);
  proxy.reset(direction * 0.055);
  follow(proxy, sphere, direction * 0.049);
  ASSERT_FALSE(proxy.contacts().empty());
  int lost = 0;
  double overlap = 0;
  for (int frame = 0; frame < frames; ++frame) {
    const double size = 1 + perFrame * (frame + 1) / 0.05;
    std::vector<Vector3f> points = surface.points;
    for (Vector3f& p : points) p *= static_cast<float>(size);
    sphere.goTo(points);
    for (int tick = 1; tick <= ticks; ++tick) {
      sphere.shape.s = static_cast<float>(tick) / ticks;
      const double now = 0.05 + perFrame * (frame + sphere.shape.s);
      follow(proxy, sphere, direction * (follows ? now - 0.001 : std::min(now, 0.05) - 0.001));
      lost += proxy.contacts().empty() ? 1 : 0;
    }
    overlap = std::max(overlap, radius - surfaces::distanceTo(sphere.shape, proxy.position()));
  }
  EXPECT_EQ(lost, 0) << perFrame << " m a frame";
  EXPECT_LT(overlap, 1e-9) << perFrame << " m a frame";
}

TEST(Proxy, NeverLosesASurfaceThatGrowsOrShrinks) {
  for (const double perFrame : {1e-6, 1e-5, 2e-4, 7e-4, 1e-3, -1e-6, -1e-5, -2e-4, -7e-4}) {
    expectNeverLost(perFrame, true);
    expectNeverLost(perFrame, false);
  }
}

}  // namespace
}  // namespace pleura::haptics
