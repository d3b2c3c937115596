#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/haptics/simulated/simulated_stylus.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;

constexpr double kPeriod = 0.001;

DeviceCapabilities lightDevice() {
  return {.model = "light", .maxForce = 10, .maxStiffness = 1000, .workspaceRadius = 0.1};
}

/// From rest at `from` at time 0, at `to` from time 1 on.
StylusPath strokeBetween(const Vector3d& from, const Vector3d& to) {
  return StylusPath({{.time = 0, .position = from}, {.time = 1, .position = to}});
}

/// Reads each period to `end`, `force` held throughout; what is told last.
DeviceState follow(SimulatedStylus& stylus, double end, const Vector3d& force = Vector3d::Zero()) {
  DeviceState state;
  for (int tick = 0; tick * kPeriod <= end + kPeriod / 2; ++tick) {
    EXPECT_TRUE(stylus.read(tick * kPeriod, state));
    EXPECT_TRUE(stylus.write({.force = force}));
  }
  return state;
}

TEST(SimulatedStylus, StandsWhereTheHandHoldsIt) {
  SimulatedStylus stylus(lightDevice(), StylusPath({{.position = {0.01, 0.02, 0.03}}}), {});
  stylus.open();
  EXPECT_EQ(follow(stylus, 0.1).position, Vector3d(0.01, 0.02, 0.03));
}

TEST(SimulatedStylus, TheHandsSpringYieldsToAForce) {
  SimulatedStylus stylus(lightDevice(), StylusPath(), {.stiffness = 200, .damping = 2});
  stylus.open();
  EXPECT_NEAR(follow(stylus, 2, {0, 1, 0}).position.y(), 1.0 / 200, 1e-9);
}

TEST(SimulatedStylus, FreeTipSlowsDownAsTheExponentialOfItsDamping) {
  // x = v m/b (1 - exp(-b t/m)), thrown by a hand that has let go.
  SimulatedStylus stylus(lightDevice(), strokeBetween(Vector3d::Zero(), {0.1, 0, 0}),
                         {.stiffness = 0, .damping = 0});
  stylus.open();
  const double m = stylus.capabilities().mass, b = stylus.capabilities().damping, t = 0.5;
  follow(stylus, t);
  EXPECT_NEAR(stylus.position().x(), 0.1 * m / b * (1 - std::exp(-b * t / m)), 1e-8);
  EXPECT_NEAR(stylus.velocity().x(), 0.1 * std::exp(-b * t / m), 1e-8);
}

TEST(SimulatedStylus, HeldTipSwingsAsTheDampedOscillator) {
  // A constant force from rest: x = F/k (1 - exp(-g t) (cos w t + g/w sin w t)), g = (b + c)/2m.
  SimulatedStylus stylus(lightDevice(), StylusPath(), {.stiffness = 400, .damping = 0.5});
  stylus.open();
  const double m = stylus.capabilities().mass, k = 400, g = (stylus.capabilities().damping + 0.5) / (2 * m);
  const double w = std::sqrt(k / m - g * g);
  DeviceState state;
  for (int tick = 0; tick <= 100; ++tick) {
    stylus.read(tick * kPeriod, state);
    stylus.write({.force = {2, 0, 0}});
    const double t = tick * kPeriod;
    const double x = 2 / k * (1 - std::exp(-g * t) * (std::cos(w * t) + g / w * std::sin(w * t)));
    EXPECT_NEAR(stylus.position().x(), x, 2e-6) << "at " << t;
  }
}

TEST(SimulatedStylus, FrictionHoldsTheTipUntilItIsOvercome) {
  auto device = lightDevice();
  device.friction = 0.5;
  SimulatedStylus stylus(device, StylusPath(), {.stiffness = 0, .damping = 0});
  stylus.open();
  follow(stylus, 1, {0.3, 0.39, 0});
  EXPECT_EQ(stylus.position(), Vector3d::Zero());

  SimulatedStylus pushed(device, StylusPath(), {.stiffness = 0, .damping = 0});
  pushed.open();
  follow(pushed, 0.1, {0.6, 0, 0});
  // m x'' = F - f_c - b x'
  const double m = device.mass, b = device.damping, t = 0.1;
  EXPECT_NEAR(pushed.position().x(), 0.1 / b * (t - m / b * (1 - std::exp(-b * t / m))), 1e-8);
}

TEST(SimulatedStylus, FrictionStopsASlidingTipWhereItsEnergyIsSpent) {
  // Without damping it slides m v^2 / (2 f_c).
  auto device = lightDevice();
  device.friction = 0.1;
  device.damping = 0;
  SimulatedStylus stylus(device, strokeBetween(Vector3d::Zero(), {0.2, 0, 0}),
                         {.stiffness = 0, .damping = 0});
  stylus.open();
  follow(stylus, 1);
  EXPECT_NEAR(stylus.position().x(), device.mass * 0.2 * 0.2 / (2 * device.friction), 2e-6);
  EXPECT_EQ(stylus.velocity(), Vector3d::Zero());
}

TEST(SimulatedStylus, WorkOfMotorsAndHandIsLostOrMoves) {
  auto device = lightDevice();
  device.friction = 0.05;
  SimulatedStylus stylus(device, strokeBetween({-0.05, 0, 0}, {0.15, 0.05, 0}),
                         {.stiffness = 300, .damping = 1});
  stylus.open();
  DeviceState state;
  for (int tick = 0; tick < 2000; ++tick) {
    stylus.read(tick * kPeriod, state);
    stylus.write({.force = {2 * std::sin(0.02 * tick), 1, 0.5}});
  }
  const auto& work = stylus.work();
  EXPECT_NEAR(work.motors + work.hand, work.lost + 0.5 * device.mass * stylus.velocity().squaredNorm(),
              1e-12);
  EXPECT_GT(work.lost, 1e-3);
}

TEST(SimulatedStylus, TheWorkspaceIsAStop) {
  SimulatedStylus stylus(lightDevice(), strokeBetween(Vector3d::Zero(), {0.3, 0.4, 0}), {});
  stylus.open();
  EXPECT_TRUE(follow(stylus, 2).position.isApprox(Vector3d(0.06, 0.08, 0), 1e-12));
  EXPECT_NEAR(stylus.velocity().norm(), 0, 1e-12);
}

TEST(SimulatedStylus, MotorsGiveNoMoreThanTheyCan) {
  SimulatedStylus stylus(lightDevice(), StylusPath(), {.stiffness = 200, .damping = 2});
  stylus.open();
  EXPECT_NEAR(follow(stylus, 2, {0, 0, 1e300}).position.z(), 10.0 / 200, 1e-9);
  DeviceState state;
  stylus.write({.force = {0, std::numeric_limits<double>::quiet_NaN(), 1}});
  stylus.read(4, state);
  EXPECT_NEAR(state.position.norm(), 0, 1e-9);
}

TEST(SimulatedStylus, AForceIsHeldUntilTheNextIsWritten) {
  // Once written, half a second of two periods and of a thousand move the tip alike.
  const auto after = [](int reads) {
    SimulatedStylus stylus(lightDevice(), StylusPath(), {});
    stylus.open();
    DeviceState state;
    stylus.read(0, state);
    stylus.write({.force = {1, 0, 0}});
    for (int i = 1; i <= reads; ++i) stylus.read(0.5 * i / reads, state);
    return stylus.position().x();
  };
  EXPECT_NEAR(after(2), after(1000), 1e-8);
  EXPECT_NEAR(after(2), 1.0 / 200, 1e-4);
}

TEST(SimulatedStylus, TellsWholeEncoderSteps) {
  auto device = lightDevice();
  device.encoderStep = 1e-4;
  SimulatedStylus stylus(device, strokeBetween(Vector3d::Zero(), {0.01, -0.02, 0.005}), {});
  stylus.open();
  DeviceState state;
  for (int tick = 0; tick < 500; ++tick) {
    stylus.read(tick * kPeriod, state);
    for (int axis = 0; axis < 3; ++axis) {
      const double steps = state.position[axis] / device.encoderStep;
      EXPECT_NEAR(steps, std::round(steps), 1e-9);
      EXPECT_LE(std::abs(state.position[axis] - stylus.position()[axis]),
                device.encoderStep / 2 * (1 + 1e-9));
    }
  }
  EXPECT_NE(state.position, stylus.position());
}

TEST(SimulatedStylus, TheToldVelocityIsAFilteredDifferenceOfTheToldPosition) {
  auto device = lightDevice();
  device.encoderStep = 7e-5;
  SimulatedStylus stylus(device, strokeBetween(Vector3d::Zero(), {0.05, 0, 0}), {}, 50);
  stylus.open();
  DeviceState state;
  double lastPosition = 0, velocity = 0;
  const double share = 1 - std::exp(-2 * std::numbers::pi * 50 * kPeriod);
  double slowest = 1, fastest = 0;
  for (int tick = 0; tick < 900; ++tick) {
    stylus.read(tick * kPeriod, state);
    if (tick > 0) velocity += share * ((state.position.x() - lastPosition) / kPeriod - velocity);
    lastPosition = state.position.x();
    EXPECT_NEAR(state.velocity.x(), velocity, 1e-9);
    if (tick < 500) continue;
    slowest = std::min(slowest, velocity);
    fastest = std::max(fastest, velocity);
  }
  // About the true one, and as noisy as steps of the encoder make it.
  EXPECT_LT(slowest, 0.05);
  EXPECT_GT(fastest, 0.05);
  EXPECT_GT(fastest - slowest, 0.001);
}

TEST(SimulatedStylus, OrientationAndButtonsAreTheHands) {
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(1, Vector3d::UnitY()));
  SimulatedStylus stylus(
      lightDevice(),
      StylusPath({{.time = 0, .buttons = 1}, {.time = 1, .orientation = turned, .buttons = 2}}), {});
  stylus.open();
  DeviceState state;
  stylus.read(0.5, state);
  stylus.write({.torque = {1, 1, 1}});
  EXPECT_EQ(state.buttons, 1u);
  EXPECT_NEAR(Eigen::AngleAxisd(state.orientation).angle(), 0.5, 1e-12);
  stylus.read(3, state);
  EXPECT_EQ(state.buttons, 2u);
  EXPECT_TRUE(state.orientation.isApprox(turned, 1e-12));
}

TEST(SimulatedStylus, TheSameCallsGiveTheSameBits) {
  const auto run = [] {
    auto device = lightDevice();
    device.friction = 0.02;
    SimulatedStylus stylus(device, strokeBetween(Vector3d::Zero(), {0.03, 0.05, 0}), {});
    stylus.open();
    std::vector<double> told;
    DeviceState state;
    double time = 0;
    for (int tick = 0; tick < 500; ++tick) {
      stylus.read(time += kPeriod * (1 + 0.3 * std::sin(tick)), state);
      stylus.write({.force = -50 * state.position - 0.5 * state.velocity});
      told.insert(told.end(), {state.position.x(), state.position.y(), state.velocity.x()});
    }
    return told;
  };
  EXPECT_EQ(run(), run());
}

TEST(SimulatedStylus, UnpluggedItIsLostUntilItIsOpenedAgain) {
  SimulatedStylus stylus(lightDevice(), StylusPath(), {});
  DeviceState state{.position = {7, 7, 7}};
  EXPECT_FALSE(stylus.read(0, state));
  stylus.open();
  EXPECT_TRUE(stylus.read(0, state));
  stylus.unplug();
  state.position = {7, 7, 7};
  EXPECT_FALSE(stylus.read(0.001, state));
  EXPECT_FALSE(stylus.write({}));
  EXPECT_EQ(state.position, Vector3d(7, 7, 7));
  EXPECT_THROW(stylus.open(), DeviceError);
  stylus.replug();
  EXPECT_FALSE(stylus.read(0.002, state));
  stylus.open();
  EXPECT_TRUE(stylus.read(0.003, state));
  EXPECT_TRUE(stylus.write({}));
}

TEST(SimulatedStylus, OpenedAgainItHasForgottenTheForce) {
  SimulatedStylus stylus(lightDevice(), StylusPath(), {});
  DeviceState state;
  const auto closeIt = [&] { stylus.close(), stylus.close(); };
  const auto loseIt = [&] { stylus.unplug(), stylus.replug(); };
  for (const std::function<void()>& end : {std::function<void()>(closeIt), std::function<void()>(loseIt)}) {
    stylus.open();
    follow(stylus, 0.1, {1, 0, 0});
    end();
    stylus.open();
    stylus.read(5, state);
    stylus.read(6, state);
    EXPECT_EQ(state.position, Vector3d::Zero());
  }
}

TEST(SimulatedStylus, AReadThatComesHoursOrDecadesLaterIsNoHurdle) {
  SimulatedStylus stylus(lightDevice(), StylusPath(), {.stiffness = 200, .damping = 2});
  stylus.open();
  DeviceState state;
  stylus.read(0, state);
  stylus.write({.force = {1, 0, 0}});
  EXPECT_TRUE(stylus.read(3600, state));
  EXPECT_LE(state.position.norm(), stylus.capabilities().workspaceRadius * (1 + 1e-12));
  EXPECT_NEAR(state.position.x(), 1.0 / 200, 1e-6);
  EXPECT_TRUE(stylus.read(1e9, state));  // decades, which would take as long in short steps
  EXPECT_LE(state.position.norm(), stylus.capabilities().workspaceRadius * (1 + 1e-12));
}

TEST(SimulatedStylus, ImpossibleFiguresAreRefused) {
  auto device = lightDevice();
  device.mass = 0;
  EXPECT_THROW(SimulatedStylus(device, StylusPath(), {}), DeviceError);
  EXPECT_THROW(SimulatedStylus(lightDevice(), StylusPath(), {.stiffness = -1}), DeviceError);
  EXPECT_THROW(
      SimulatedStylus(lightDevice(), StylusPath(), {.damping = std::numeric_limits<double>::quiet_NaN()}),
      DeviceError);
}

}  // namespace
}  // namespace pleura::haptics
