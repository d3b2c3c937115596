#include <gtest/gtest.h>

#include <pleura/haptics/safety/passivity.h>
#include <pleura/haptics/safety/stiffness_limit.h>
#include <pleura/tests/haptics/simulated/virtual_wall.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;

TEST(PassivityObserver, SumsTheWorkOfHeldForces) {
  PassivityObserver observer;
  EXPECT_EQ(observer.observe({1, 1, 1}), 0);  // where it is first is no way
  observer.hold({0, 2, 0});
  EXPECT_EQ(observer.observe({5, 0.5, 1}), 1);   // against the force: the rendering takes
  EXPECT_EQ(observer.observe({5, 2.5, 1}), -3);  // along it: it gives
  EXPECT_EQ(observer.energy(), -3);
  observer.restart();
  EXPECT_EQ(observer.observe({0, 0, 0}), 0);
}

TEST(PassivityObserver, AgreesWithTheWorkOfTheMotors) {
  VirtualWall wall{.stiffness = 300, .handStiffness = 100};
  auto tip = wall.released(0.001, -0.03);
  PassivityObserver observer;
  DeviceState state;
  tip.open();
  for (int tick = 0; tick < 500; ++tick) {
    tip.read(tick * wall.period, state);
    EXPECT_NEAR(observer.observe(state.position), -tip.work().motors, 1e-12);
    const Vector3d force(std::max(0.0, -300 * state.position.x()), 0, 0);
    observer.hold(force);
    tip.write({.force = force});
  }
  EXPECT_GT(std::abs(observer.energy()), 1e-4);
}

TEST(Passivated, APassiveRenderingIsLeftAlone) {
  const Vector3d force(1, 2, 3);
  EXPECT_EQ(passivated(force, {1, 1, 1}, 0.5, 0.001, 10), force);
  EXPECT_EQ(passivated(force, {1, 1, 1}, 0, 0.001, 10), force);
  EXPECT_EQ(passivated(force, Vector3d::Zero(), -1, 0.001, 10), force);
}

TEST(Passivated, DampingTakesTheDebtWithinAPeriod) {
  const Vector3d v(0.3, 0, 0.4), force(1, 2, 3);
  const Vector3d changed = passivated(force, v, -1e-4, 0.001, 10);
  EXPECT_NEAR((force - changed).dot(v) * 0.001, 1e-4, 1e-15);
  EXPECT_TRUE((force - changed).cross(v).isZero(1e-15));
}

TEST(Passivated, NoMoreDampingThanTheDeviceBears) {
  const Vector3d v(0.5, 0, 0);
  EXPECT_TRUE(passivated(Vector3d::Zero(), v, -1, 0.001, 10).isApprox(-10 * v));
  EXPECT_TRUE(passivated(Vector3d::Zero(), 1e-200 * v, -1, 0.001, 10).isApprox(-10e-200 * v));
}

TEST(Passivated, ASpringOfFourTimesTheLimitDivergesWithoutItAndComesToRestWithIt) {
  VirtualWall spring{.stiffness = 4 * stiffnessLimit(0.2, 0, 0.001), .encoderStep = 5e-5, .isTwoSided = true};
  const auto lateSwing = [](const VirtualWall& of) {
    auto tip = of.released(0.001, 0);
    double most = 0;
    of.render(tip, [&](int tick, double) {
      if (tick > 9000) most = std::max(most, std::abs(tip.position().x()));
      return tick < 10'000;
    });
    return most;
  };
  EXPECT_GT(lateSwing(spring), 0.099);  // to the stop of the workspace
  spring.controllerDamping = 4;
  EXPECT_LT(lateSwing(spring), 3 * spring.encoderStep);
}

TEST(Passivated, AHandHoldsAWallOfFourTimesTheLimitStill) {
  VirtualWall wall{.stiffness = 4 * stiffnessLimit(0.2, 0, 0.001), .encoderStep = 5e-5, .handStiffness = 50};
  EXPECT_GT(wall.swing(), 0.01);
  wall.controllerDamping = 4;
  EXPECT_LT(wall.swing(), 3 * wall.encoderStep);
}

}  // namespace
}  // namespace pleura::haptics
