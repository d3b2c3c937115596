#include <cmath>
#include <limits>
#include <memory>

#include "fake_device.h"
#include <gtest/gtest.h>

#include <pleura/haptics/servo/servo.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector3i;

constexpr double kTick = 1e-3;
constexpr double kRadius = 0.0025;

/// A servo over a square metre that is seen from +z, at a height that the test sets each frame.
class ServoOverFloor : public ::testing::Test {
 protected:
  ServoOverFloor() : servo(device, kTick) {
    device.state = [this](double) { return DeviceState{.position = at, .velocity = velocity}; };
  }

  void publish(double height, double duration, TouchSurface surface = {.stiffness = 100}) {
    TouchFrame& frame = servo.frames().back();
    frame.duration = duration;
    frame.tipRadius = kRadius;
    frame.shapes.resize(1);
    frame.instants.resize(1);
    TouchFrameShape& shape = frame.shapes.front();
    shape.mesh = mesh;
    shape.points.fit(*mesh, points);
    shape.stamp = ++stamp;
    shape.pose.translation().z() = height;
    shape.surface = surface;
    edit(frame);
    servo.frames().publish();
  }

  void tick(int times = 1) {
    for (int k = 0; k < times; ++k) servo.tick(kTick * ticks++);
  }

  /// Comes down from above to `depth` under the floor, and stays.
  void touch(double depth) {
    at.z() = 2 * kRadius;
    publish(0, 0);
    tick(2);
    at.z() = kRadius - depth;
    tick(200);  // longer than the force takes to rise
  }

  const ServoReport& report() {
    servo.reports().take();
    return servo.reports().taken();
  }

  FakeDevice device;
  Servo servo;
  Vector3d at = Vector3d::Zero();
  Vector3d velocity = Vector3d::Zero();
  std::function<void(TouchFrame&)> edit = [](TouchFrame&) {};
  std::vector<Vector3f> points{{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
  std::vector<Vector3i> triangles{{0, 1, 2}, {0, 2, 3}};
  std::shared_ptr<const TouchMesh> mesh = std::make_shared<TouchMesh>(points, triangles);
  std::uint64_t stamp = 0;
  int ticks = 0;
};

TEST_F(ServoOverFloor, PushesBackByStiffnessTimesDepth) {
  touch(0.01);
  EXPECT_NEAR(report().force.z(), 1, 1e-6);
  EXPECT_NEAR(device.given.back().force.z(), 1, 1e-6);
  ASSERT_EQ(report().contactCount, 1);
  EXPECT_NEAR(report().contacts[0].depth, 0.01, 1e-6);
  EXPECT_NEAR(report().proxyPosition.z(), kRadius, 1e-6);
}

TEST_F(ServoOverFloor, NothingIsStifferThanTheDeviceHolds) {
  edit = [](TouchFrame& frame) { frame.shapes[0].surface.stiffness = 1e6; };
  touch(0.001);
  EXPECT_NEAR(report().force.z(), servo.stiffnessLimit() * 0.001, 1e-6);
  EXPECT_NEAR(servo.stiffnessLimit(), 2 * 0.2 / kTick, 1e-9);
}

TEST_F(ServoOverFloor, TheForceRisesAtFirstContact) {
  at.z() = 2 * kRadius;
  publish(0, 0);
  tick(2);
  at.z() = kRadius - 0.01;
  tick();
  EXPECT_LT(device.given.back().force.z(), 0.1) << "a tenth of what it will be";
  double last = 0;
  for (int k = 0; k < 60; ++k) {
    tick();
    EXPECT_GE(device.given.back().force.z(), last);
    EXPECT_LT(device.given.back().force.z() - last, 0.05);
    last = device.given.back().force.z();
  }
  EXPECT_NEAR(last, 1, 1e-6);
}

TEST_F(ServoOverFloor, TheForceIsLimited) {
  touch(0.3);
  EXPECT_NEAR(device.given.back().force.norm(), 5, 1e-9) << "the device's own limit";
  edit = [](TouchFrame& frame) { frame.forceLimit = 2; };
  publish(0, 0);
  tick(2);
  EXPECT_NEAR(device.given.back().force.norm(), 2, 1e-9);
  edit = [](TouchFrame& frame) { frame.forceLimit = 100; };
  publish(0, 0);
  tick(2);
  EXPECT_NEAR(device.given.back().force.norm(), 5, 1e-9) << "no scene asks for more than the device's";
}

TEST_F(ServoOverFloor, WithADeadmansSwitchOnlyTheMainButtonGivesForce) {
  edit = [](TouchFrame& frame) { frame.deadmansSwitch = true; };
  touch(0.01);
  EXPECT_EQ(device.given.back().force, Vector3d::Zero());
  EXPECT_EQ(report().contactCount, 1) << "what is touched is told all the same";
  device.state = [this](double) { return DeviceState{.position = at, .buttons = 1}; };
  tick(200);
  EXPECT_NEAR(device.given.back().force.z(), 1, 1e-6);
}

TEST_F(ServoOverFloor, ALargeWorkspaceMakesNothingHarder) {
  edit = [](TouchFrame& frame) {
    frame.workspace.scale = 10;
    frame.workspace.placement.linear() = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitX()).toRotationMatrix();
  };
  // the device's +y is the scene's +z
  device.state = [this](double) { return DeviceState{.position = Vector3d(0, at.z(), 0)}; };
  at.z() = 0.001;
  publish(0, 0);
  tick(2);
  at.z() = kRadius / 10 - 0.01;  // 1 cm of the hand under the floor, 10 cm of the scene
  tick(200);
  EXPECT_NEAR(device.given.back().force.y(), 1, 1e-5) << "100 N/m of the hand's metres";
  EXPECT_NEAR(report().contacts[0].depth, 0.1, 1e-5);
  EXPECT_NEAR(report().force.z(), 1, 1e-5) << "the force in the scene's frame";
}

TEST_F(ServoOverFloor, MovesEvenlyFromFrameToFrame) {
  touch(0.01);
  const double start = ticks * kTick;
  constexpr double kDuration = 0.033;
  for (int frame = 1; frame <= 5; ++frame) {
    publish(0.002 * frame, kDuration);
    while (ticks * kTick <= start + kDuration * frame) {
      tick();
      const double height = 0.002 * ((ticks - 1) * kTick - start + kTick) / kDuration;
      EXPECT_NEAR(report().proxyPosition.z() - kRadius, std::min(height, 0.01),
                  0.002 * 1.001 * kTick / kDuration);
    }
  }
}

TEST_F(ServoOverFloor, AFrameThatComesLateIsGoneOnFromWhereThingsStood) {
  touch(0.01);
  tick(500);
  publish(0.003, 0.030);
  double last = report().proxyPosition.z();
  for (int k = 0; k < 40; ++k) {
    tick();
    EXPECT_LE(report().proxyPosition.z() - last, 0.003 / 30 * 1.01) << "no jump";
    last = report().proxyPosition.z();
  }
  EXPECT_NEAR(last, 0.003 + kRadius, 1e-6);
}

TEST_F(ServoOverFloor, ALostDeviceIsToldAndGetsItsForceBackSlowly) {
  touch(0.01);
  device.isThere = false;
  tick(3);
  EXPECT_FALSE(report().isConnected);
  device.isThere = true;
  tick(100);
  EXPECT_TRUE(report().isConnected);
  EXPECT_TRUE(report().isStopped) << "quiet first";
  EXPECT_EQ(device.given.back().force, Vector3d::Zero());
}

TEST_F(ServoOverFloor, NumbersThatAreNoneGiveNoForce) {
  touch(0.01);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vector3d& bad : {Vector3d(nan, 0, 0), Vector3d(0, 0, std::numeric_limits<double>::infinity())}) {
    at = bad;
    tick();
    EXPECT_EQ(device.given.back().force, Vector3d::Zero());
    EXPECT_TRUE(report().isStopped);
  }
  at = Vector3d(0, 0, kRadius - 0.01);
  tick(1000);
  EXPECT_FALSE(report().isStopped);
  EXPECT_NEAR(device.given.back().force.z(), 1, 1e-6) << "and it comes back";
}

TEST_F(ServoOverFloor, AStormOfMissedDeadlinesGivesNoForce) {
  touch(0.01);
  for (int k = 0; k < 50; ++k) servo.tick(kTick * ticks++, true);
  EXPECT_TRUE(report().isStopped);
  EXPECT_EQ(device.given.back().force, Vector3d::Zero());
}

TEST_F(ServoOverFloor, ARisingFloorMayPushTheHand) {
  // The breath does work on a hand; that is no energy of the rendering, and it is not damped away.
  touch(0.002);
  for (int frame = 1; frame <= 30; ++frame) {
    at.z() += 0.001;
    velocity.z() = 0.001 / 0.033;
    publish(0.001 * frame, 0.033);
    tick(33);
  }
  EXPECT_NEAR(report().force.z(), 0.2, 0.05);
}

TEST_F(ServoOverFloor, ASpringCatchesTheTip) {
  edit = [](TouchFrame& frame) {
    frame.effects = {{.id = 7, .kind = SpringForce{.position = {0, 0, 0.1}, .stiffness = 50}}};
  };
  at.z() = 0.105;
  publish(0, 0);
  tick(200);
  EXPECT_NEAR(device.given.back().force.z(), -0.25, 1e-9);
  ASSERT_EQ(report().effectCount, 1);
  EXPECT_TRUE(report().isEffectActive[0]);
  EXPECT_NEAR(report().effectForces[0].z(), -0.25, 1e-9);
}

}  // namespace
}  // namespace pleura::haptics
