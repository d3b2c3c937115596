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

}  // namespace
}  // namespace pleura::haptics
