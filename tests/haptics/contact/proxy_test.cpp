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

/// A ball that 600 triangles are about, many more than it keeps.
TEST(Proxy, RestsOnASurfaceFinerThanItLooksAt) {
  constexpr double ball = 5e-3;
  const Touchable sphere(surfaces::sphere(300, 250, 0.01));
  for (const Vector3d& direction :
       {Vector3d(0, 0, 1), Vector3d(0, 0.1, 1), Vector3d(1, 2, 3), Vector3d(1, 0, 0)}) {
    const Vector3d normal = direction.normalized();
    Proxy proxy(ball);
    proxy.reset(0.03 * normal);
    for (int tick = 0; tick < 200; ++tick) follow(proxy, sphere, (0.016 - 2e-5 * tick) * normal);
    EXPECT_LT((proxy.position() - 0.015 * normal).norm(), 2e-5);
    EXPECT_FALSE(proxy.contacts().empty());
  }
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

/// So far in one tick that the steps of the ball are used up on its way around.
TEST(Proxy, NeverLosesASurfaceThatTheDeviceJumpsAboutIn) {
  for (const double friction : {0.0, 0.4}) {
    Touchable sphere(surfaces::sphere(300, 250, surfaces::bumpyRadius));
    sphere.shape.surface.staticFriction = sphere.shape.surface.dynamicFriction = friction;
    std::mt19937 random(1);
    Vector3d direction = Vector3d::UnitZ();
    Proxy proxy(radius);
    proxy.reset(0.06 * direction);
    for (int jump = 0; jump < 400; ++jump) {
      follow(proxy, sphere, 0.047 * direction);
      ASSERT_FALSE(proxy.contacts().empty()) << jump << ", friction " << friction;
      EXPECT_GT(proxy.position().norm(), surfaces::bumpyRadius(proxy.position().normalized()));
      direction = (direction + surfaces::randomPoint(random, 0.8)).normalized();
    }
  }
}

void settle(Proxy& proxy, const Touchable& touchable, const Vector3d& device) {
  for (int k = 0; k < 20; ++k) follow(proxy, touchable, device);
}

TEST(Proxy, DepthAndNormalOnASphereAreTheClosedForm) {
  const Touchable sphere(surfaces::sphere(300, 250, 0.01));  // flat to 0.6 um
  Proxy proxy(radius);
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    const Vector3d normal = surfaces::randomPoint(random, 1).normalized();
    const double depth = 0.0002 + 0.003 * (i / 50.0);
    proxy.reset(0.02 * normal);
    settle(proxy, sphere, (0.011 - depth) * normal);
    Vector3d pushed = Vector3d::Zero();
    for (const ProxyContact& contact : proxy.contacts()) pushed += contact.depth * contact.normal;
    EXPECT_LT((pushed - depth * normal).norm(), 1e-6 + 0.01 * depth);
    EXPECT_NEAR(pushed.norm(), depth, 1e-6);
  }
}

/// Where a ball's centre is nearest to the device without the ball in the box; the device is outside the box,
/// or deeper under `face` (an axis) than under none.
Vector3d nearestOutsideBox(const Vector3d& half, const Vector3d& device, int face) {
  const Vector3d on = device.cwiseMin(half).cwiseMax(-half);
  if (on != device) return on + radius * (device - on).normalized();
  Vector3d result = device;
  result[face] = (device[face] < 0 ? -1 : 1) * (half[face] + radius);
  return result;
}

TEST(Proxy, RestsOnABoxWhereTheClosedFormSays) {
  const Vector3d half(0.01, 0.006, 0.012);
  std::mt19937 random(3);
  for (const int squares : {1, 7}) {
    const Touchable box(surfaces::box(half, squares));
    Proxy proxy(radius);
    int places = 0;
    while (places < 300) {
      const Vector3d device = surfaces::randomPoint(random, 0.013);
      const Vector3d inside = half - device.cwiseAbs();
      int face = 0;
      const double depth = inside.minCoeff(&face);
      const Vector3d out = (-inside).cwiseMax(0);
      if (depth > 0.002 || out.norm() > 0.9 * radius)
        continue;  // where a nearer face may be nearer for one radius
      ++places;
      Vector3d start = device;
      start[face] += device[face] < 0 ? -0.005 : 0.005;
      if (depth < 0) start = device + 0.005 * out.cwiseProduct(device.cwiseSign()).normalized();
      proxy.reset(start);
      settle(proxy, box, device);
      const Vector3d expected = nearestOutsideBox(half, device, face);
      EXPECT_LT((proxy.position() - expected).norm(), 1e-6) << device.transpose();
      ASSERT_EQ(proxy.contacts().size(), 1U) << device.transpose();
      EXPECT_NEAR(proxy.contacts()[0].depth, (expected - device).norm(), 1e-6);
      EXPECT_LT((proxy.contacts()[0].normal - (expected - device).normalized()).norm(), 1e-3);
    }
  }
}

TEST(Proxy, StandsStillBitForBit) {
  const auto bumpy = [](const Vector3d& d) {
    return 0.013 + 0.002 * std::sin(9 * d.x()) * std::cos(8 * d.y());
  };
  const Surface shapes[] = {
      surfaces::sphere(30, 24, bumpy), surfaces::box({0.01, 0.006, 0.012}, 3),
      surfaces::sheet(0.012, 4, [](double x, double) { return 2 * std::abs(x) - 0.01; })};
  std::mt19937 random(4);
  for (const Surface& surface : shapes)
    for (const double friction : {0.0, 0.4})
      for (int place = 0; place < 50; ++place) {
        Touchable touchable(surface);
        touchable.shape.surface.twoSided = true;
        touchable.shape.surface.staticFriction = friction;
        touchable.shape.surface.dynamicFriction = friction / 2;
        const Vector3d device = surfaces::randomPoint(random, 0.012);
        Proxy proxy(radius);
        proxy.reset({0, 0, 0.03});
        for (int k = 0; k < 200; ++k) follow(proxy, touchable, device);
        const Vector3d before = proxy.position();
        for (int k = 0; k < 40; ++k) {
          // new frames of the same points are the same surface
          if (k % 10 == 0) touchable.goTo(surface.points);
          touchable.shape.s = static_cast<float>(k % 10) / 10;
          follow(proxy, touchable, device);
          EXPECT_EQ(proxy.position(), before);
        }
      }
}

TEST(Proxy, StaysWhereItSticksToASurfaceThatMoves) {
  Touchable sphere(surfaces::sphere(60, 50, 0.05));
  sphere.shape.surface.staticFriction = sphere.shape.surface.dynamicFriction = 10;
  Proxy proxy(radius);
  proxy.reset({0, 0, 0.055});
  const Vector3d device(0.001, 0.002, 0.049);
  settle(proxy, sphere, device);
  const Vector3d place = proxy.position();
  for (int tick = 1; tick <= 500; ++tick) {
    sphere.shape.pose = Eigen::Translation3d(1e-5 * tick, 0, 2e-6 * tick) *
                        Eigen::AngleAxisd(1e-4 * tick, Vector3d(1, 2, 3).normalized());
    follow(proxy, sphere, device);
    ASSERT_LT((proxy.position() - sphere.shape.pose * place).norm(), 1e-8) << tick;
  }
}

TEST(Proxy, SlidesAtTheConeOfFriction) {
  Touchable floor(surfaces::sheet(0.1, 7, [](double, double) { return 0; }));
  floor.shape.surface.staticFriction = 0.5;
  floor.shape.surface.dynamicFriction = 0.3;
  Proxy proxy(radius);
  proxy.reset({0, 0, 0.005});
  follow(proxy, floor, {0, 0, 0});
  for (const double x : {1e-4, 3e-4, 4.9e-4}) {  // within 0.5 of 1 mm
    follow(proxy, floor, {x, 0, 0});
    EXPECT_NEAR(proxy.position().x(), 0, 1e-9);
  }
  for (const double x : {5.1e-4, 6e-4, 1e-3, 5e-3}) {
    follow(proxy, floor, {x, 0, 0});
    EXPECT_NEAR(proxy.position().x(), x - 3e-4, 1e-8);
  }
  follow(proxy, floor, {5e-3, 0, 0});  // rests: static again
  follow(proxy, floor, {5.1e-3, 0, 0});
  EXPECT_NEAR(proxy.position().x(), 5e-3 - 3e-4, 1e-8);
}

TEST(Proxy, NeverLosesABodyThatMovesRigidly) {
  const auto bumpy = [](const Vector3d& d) {
    return 0.013 + 0.002 * std::sin(9 * d.x()) * std::cos(8 * d.y());
  };
  for (const double perFrame : {7e-4, 7e-3})    // [m] in 33 ticks: a rib's, and ten times that
    for (const double turn : {0.0, 0.05, 0.5})  // [rad] in 33 ticks
      for (const double friction : {0.0, 0.5}) {
        Touchable body(surfaces::sphere(40, 30, bumpy));
        body.shape.surface.staticFriction = body.shape.surface.dynamicFriction = friction;
        Proxy proxy(radius);
        proxy.reset({0, 0, 0.03});
        const Vector3d inside(0.001, 0.002, 0.011);
        settle(proxy, body, inside);
        for (int tick = 1; tick <= 1000; ++tick) {
          const double frames = tick / 33.0;
          body.shape.pose = Eigen::Translation3d(perFrame * frames * Vector3d(0.3, -0.5, 0.8)) *
                            Eigen::AngleAxisd(turn * frames, Vector3d(1, 2, 3).normalized());
          follow(proxy, body, body.shape.pose * inside);
          ASSERT_FALSE(proxy.contacts().empty())
              << perFrame << ' ' << turn << ' ' << friction << " tick " << tick;
          ASSERT_LT(radius - surfaces::distanceTo(body.shape, proxy.position()), 2e-9);
        }
      }
}

TEST(Proxy, GoesTheSameWayInAFrameThatIsTurned) {
  const auto bumpy = [](const Vector3d& d) {
    return 0.013 + 0.002 * std::sin(9 * d.x()) * std::cos(8 * d.y());
  };
  Touchable body(surfaces::sphere(40, 30, bumpy)), turned(surfaces::sphere(40, 30, bumpy));
  turned.shape.pose =
      Eigen::Translation3d(0.3, -1, 0.2) * Eigen::AngleAxisd(2, Vector3d(1, -2, 0.5).normalized());
  Proxy proxy(radius), other(radius);
  proxy.reset({0, 0, 0.03});
  other.reset(turned.shape.pose * Vector3d(0, 0, 0.03));
  for (int tick = 0; tick < 1000; ++tick) {
    const Vector3d device(0.006 * std::sin(0.01 * tick), 0.006 * std::sin(0.017 * tick), 0.01);
    follow(proxy, body, device);
    follow(other, turned, turned.shape.pose * device);
    ASSERT_LT((turned.shape.pose * proxy.position() - other.position()).norm(), 1e-6) << tick;
  }
}

TEST(Proxy, FeelsNothingFromInsideUntilItHasLeft) {
  const Touchable sphere(surfaces::sphere(60, 50, 0.05));
  for (const double step : {1e-4, 5e-4, 3e-3}) {
    Proxy proxy(radius);
    proxy.reset({0, 0, 0.03});
    double z = 0.03;
    for (; z < 0.053; z += step) {
      follow(proxy, sphere, {0.001, 0, z});
      EXPECT_TRUE(proxy.contacts().empty());
      EXPECT_EQ(proxy.position(), Vector3d(0.001, 0, z));
    }
    for (; z > 0.048; z -= step) follow(proxy, sphere, {0.001, 0, z});
    EXPECT_FALSE(proxy.contacts().empty());
    EXPECT_GT(proxy.position().z(), 0.0509);
  }
}

TEST(Proxy, FeelsASheetFromBehindOnlyIfItHasTwoSides) {
  Touchable sheet(surfaces::sheet(0.02, 5, [](double, double) { return 0; }));
  for (const bool twoSided : {false, true})
    for (const double step : {1e-4, 3e-3, 0.05}) {
      sheet.shape.surface.twoSided = twoSided;
      Proxy proxy(radius);
      proxy.reset({0.001, 0.002, -0.01});
      for (double z = -0.01; z < 0.01; z += step) follow(proxy, sheet, {0.001, 0.002, z});
      follow(proxy, sheet, {0.001, 0.002, 0.01});
      EXPECT_NEAR(proxy.position().z(), twoSided ? -radius : 0.01, 1e-9);
    }
}

TEST(Proxy, RollsAroundARimAndThenIsBehind) {
  const Touchable sheet(surfaces::sheet(0.02, 5, [](double, double) { return 0; }));
  Proxy proxy(radius);
  proxy.reset({0, 0, 0.005});
  for (double turn = 0; turn < 3; turn += 0.01)
    follow(proxy, sheet, {0.02 + 0.005 * std::sin(turn), 0, 0.005 * std::cos(turn)});
  follow(proxy, sheet, {0.018, 0, -0.002});
  EXPECT_EQ(proxy.position(), Vector3d(0.018, 0, -0.002));
  follow(proxy, sheet, {0.018, 0, 0.002});
  EXPECT_EQ(proxy.position(), Vector3d(0.018, 0, 0.002));
  follow(proxy, sheet, {0.018, 0, -0.001});
  EXPECT_NEAR(proxy.position().z(), radius, 1e-9);
}

TEST(Proxy, NoJumpTakesItThrough) {
  std::mt19937 random(5);
  const Touchable wall(surfaces::box({1, 1, 1e-4}, 40));
  for (int i = 0; i < 200; ++i) {
    Proxy proxy(radius);
    Vector3d start = surfaces::randomPoint(random, 0.3), device = surfaces::randomPoint(random, 0.3);
    start.z() = std::abs(start.z()) + 0.002;
    device.z() = -std::abs(device.z());
    proxy.reset(start);
    for (int k = 0; k < 5; ++k) {
      follow(proxy, wall, device);
      EXPECT_GE(proxy.position().z(), 0.0011 - 1e-9);
    }
    EXPECT_LT((proxy.position() - Vector3d(device.x(), device.y(), 0.0011)).norm(), 1e-6);
  }
}

TEST(Proxy, IsPushedByASurfaceThatComesFast) {
  for (const double perTick : {1e-4, 5e-4, 1.4e-3}) {
    Touchable wall(surfaces::box({0.05, 0.05, 1e-4}, 4));
    Proxy proxy(radius);
    proxy.reset({0.001, 0, 0.01});
    for (int tick = 0; tick * perTick < 0.02; ++tick) {
      wall.shape.pose.translation().z() = tick * perTick;
      follow(proxy, wall, {0.001, 0, 0.01});
      ASSERT_GT(proxy.position().z(), tick * perTick + 0.0011 - 1e-9);
    }
    EXPECT_FALSE(proxy.contacts().empty());
  }
}

TEST(Proxy, RestsInTheCornerOfSeveralShapes) {
  const Surface surface = surfaces::box({0.02, 0.02, 0.02}, 2);
  Touchable x(surface, 1), y(surface, 2), z(surface, 3);
  x.shape.pose.translation() = Vector3d(-0.02, 0, 0);
  y.shape.pose.translation() = Vector3d(0, -0.02, 0);
  z.shape.pose.translation() = Vector3d(0, 0, -0.02);
  const TouchShape shapes[] = {x.shape, y.shape, z.shape};
  Proxy proxy(radius);
  proxy.reset({0.01, 0.01, 0.01});
  const Vector3d device(-0.001, -0.002, -0.003);
  for (int k = 0; k < 10; ++k) proxy.follow(shapes, device);
  EXPECT_LT((proxy.position() - Vector3d::Constant(radius)).norm(), 1e-9);
  ASSERT_EQ(proxy.contacts().size(), 3U);
  for (const ProxyContact& contact : proxy.contacts())
    EXPECT_NEAR(contact.depth, radius - device[static_cast<int>(contact.shape) - 1], 1e-9);
  proxy.follow(std::span(shapes, 2), device);  // the third is gone
  EXPECT_NEAR(proxy.position().z(), device.z(), 1e-9);
  EXPECT_EQ(proxy.contacts().size(), 2U);
}

TEST(Proxy, GivesWayBetweenShapesThatCloseOnIt) {
  const Surface surface = surfaces::box({0.02, 0.02, 0.01}, 3);
  Touchable below(surface, 1), above(surface, 2);
  Proxy proxy(radius);
  proxy.reset({0, 0, 0});
  for (int tick = 0; tick <= 1000; ++tick) {
    const double half = 0.002 - 2.1e-6 * tick;  // they end in each other
    below.shape.pose.translation().z() = -0.01 - half;
    above.shape.pose.translation().z() = 0.01 + half;
    const TouchShape shapes[] = {below.shape, above.shape};
    proxy.follow(shapes, {0, 0, -0.0005});
    ASSERT_TRUE(proxy.position().allFinite());
    ASSERT_LE(proxy.position().norm(), 0.05);
    if (half > 0) {
      EXPECT_LE(std::abs(proxy.position().z()), half) << tick;
    }
  }
}

TEST(Proxy, StaysWhenTheDeviceIsNowhere) {
  const Touchable sphere(surfaces::sphere(60, 50, 0.05));
  Proxy proxy(radius);
  proxy.reset({0, 0, 0.06});
  settle(proxy, sphere, {0, 0.001, 0.049});
  const Vector3d before = proxy.position();
  const double depth = proxy.contacts()[0].depth;
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
    follow(proxy, sphere, {bad, 0, 0});
    EXPECT_EQ(proxy.position(), before);
    ASSERT_FALSE(proxy.contacts().empty());
    EXPECT_EQ(proxy.contacts()[0].depth, depth);
  }
}

TEST(Proxy, IsPulledOntoAMagneticSurfaceAndLetGo) {
  Touchable sphere(surfaces::sphere(120, 100, 0.05));
  sphere.shape.surface.magneticDistance = 0.003;
  Proxy proxy(radius);
  proxy.reset({0, 0, 0.06});
  follow(proxy, sphere, {0, 0.01, 0.055});
  EXPECT_EQ(proxy.position(), Vector3d(0, 0.01, 0.055));
  for (const double turn : {0.0, 0.01, 0.05, 0.2, 0.5}) {
    const Vector3d out(0, std::sin(turn), std::cos(turn));
    settle(proxy, sphere, 0.0535 * out);
    EXPECT_NEAR(surfaces::distanceTo(sphere.shape, proxy.position()), radius, 1e-7);
    EXPECT_LT((proxy.position() - 0.051 * out).norm(), 1e-4);
    ASSERT_EQ(proxy.contacts().size(), 1U);
    EXPECT_NEAR(proxy.contacts()[0].depth, -0.0025, 3e-5);  // the sphere is flat to 20 um
  }
  follow(proxy, sphere, {0, 0, 0.0545});
  EXPECT_EQ(proxy.position(), Vector3d(0, 0, 0.0545));
  EXPECT_TRUE(proxy.contacts().empty());
}

}  // namespace
}  // namespace pleura::haptics
