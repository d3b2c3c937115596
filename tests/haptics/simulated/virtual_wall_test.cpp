// What is unstable on a device is unstable on the simulated one, and where theory says it is.
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <pleura/haptics/safety/stiffness_limit.h>
#include <pleura/tests/haptics/simulated/virtual_wall.h>
namespace pleura::haptics {
namespace {

struct LoopAndDamping {
  double period, damping;
};

const std::vector<LoopAndDamping>& loopsAndDampings() {
  static const std::vector<LoopAndDamping> all = [] {
    std::vector<LoopAndDamping> pairs;
    for (const double period : {0.0005, 0.001, 0.002})
      for (const double damping : {0.1, 0.2, 0.5, 1.0}) pairs.push_back({period, damping});
    return pairs;
  }();
  return all;
}

constexpr double kEncoderStep = 5e-5;  // [m] of a common stylus
constexpr double kStart = 0.001;       // [m] from rest where VirtualWall::swing() begins

VirtualWall heldWall(const LoopAndDamping& of, double stiffness) {
  return {.stiffness = stiffness,
          .period = of.period,
          .damping = of.damping,
          .encoderStep = kEncoderStep,
          .handStiffness = 50};
}

TEST(VirtualWall, MeasuredStiffnessLimitIsTwiceDampingOverPeriod) {
  for (const auto& each : loopsAndDampings()) {
    const double theory = stiffnessLimit(each.damping, 0, each.period);
    const double measured =
        measuredLimit(0.3 * theory, 3 * theory, [&](double K) { return heldWall(each, K).swing() < kStart; });
    EXPECT_NEAR(measured / theory, 1, 0.05) << "b " << each.damping << ", T " << each.period;
    RecordProperty(fmt::format("limit at b {} T {}", each.damping, each.period), fmt::format("{}", measured));
  }
}

TEST(VirtualWall, AHandsDampingCountsAsTheDevices) {
  VirtualWall wall = heldWall({.period = 0.001, .damping = 0.2}, 0);
  wall.handDamping = 0.3;
  const double theory = stiffnessLimit(0.2 + 0.3, 0, 0.001);
  const double measured = measuredLimit(0.3 * theory, 3 * theory, [&](double K) {
    wall.stiffness = K;
    return wall.swing() < kStart;
  });
  EXPECT_NEAR(measured / theory, 1, 0.05);
}

TEST(VirtualWall, BelowTheLimitSwingsDieAndAboveItTheyLast) {
  for (const auto& each : loopsAndDampings()) {
    const double theory = stiffnessLimit(each.damping, 0, each.period);
    EXPECT_LT(heldWall(each, 0.7 * theory).swing(), 4 * kEncoderStep)
        << "b " << each.damping << ", T " << each.period;
    EXPECT_GT(heldWall(each, 1.3 * theory).swing(), 2 * kStart)
        << "b " << each.damping << ", T " << each.period;
  }
}

/// The greatest share of its energy that a free tip gains when it bounces off the wall, at several speeds and
/// times of contact within a period.
double worstGainOfABounce(VirtualWall wall) {
  double worst = -1;
  for (const double speed : {0.02, 0.05, 0.2}) {
    for (int phase = 0; phase < 10; ++phase) {
      const double start = speed * wall.period * phase / 10 + 1e-5;
      auto tip = wall.stylus(StylusPath(
          {{.time = 0, .position = {start, 0, 0}}, {.time = 1, .position = {start - speed, 0, 0}}}));
      bool hasBeenIn = false;
      wall.render(tip, [&](int, double x) {
        hasBeenIn = hasBeenIn || x < 0;
        return !(hasBeenIn && x >= 0);
      });
      worst = std::max(worst, tip.velocity().squaredNorm() / (speed * speed) - 1);
    }
  }
  return worst;
}

TEST(VirtualWall, AFreeTipGainsNothingFromABounceBelowTheLimitAndSomethingAbove) {
  for (const auto& each : loopsAndDampings()) {
    const double theory = stiffnessLimit(each.damping, 0, each.period);
    VirtualWall wall{.stiffness = 0.95 * theory, .period = each.period, .damping = each.damping};
    EXPECT_LT(worstGainOfABounce(wall), 0) << "b " << each.damping << ", T " << each.period;
    wall.stiffness = 1.5 * theory;
    EXPECT_GT(worstGainOfABounce(wall), 0.01) << "b " << each.damping << ", T " << each.period;
  }
}

/// What a hand has put in [J] when it has pressed into the wall, stayed, and come back to rest.
double workOfAStroke(const VirtualWall& wall) {
  auto tip = wall.stylus(StylusPath({{.time = 0, .position = {0.002, 0, 0}},
                                     {.time = 0.4, .position = {-0.02, 0, 0}},
                                     {.time = 2.4, .position = {-0.02, 0, 0}},
                                     {.time = 2.8, .position = {0.002, 0, 0}}}));
  wall.render(tip, [&](int tick, double) { return tick * wall.period < 4; });
  return tip.work().hand;
}

TEST(VirtualWall, AHandGetsNoEnergyOutOfAStroke) {
  for (const auto& each : loopsAndDampings()) {
    auto wall = heldWall(each, 0.95 * stiffnessLimit(each.damping, 0, each.period));
    wall.friction = wall.stiffness * wall.encoderStep / 2;
    wall.handStiffness = 200;
    EXPECT_GT(workOfAStroke(wall), 0) << "b " << each.damping << ", T " << each.period;
  }
}

TEST(VirtualWall, AboveTheLimitAHandGetsEnergyOutOfAStroke) {
  for (const auto& each : loopsAndDampings()) {
    auto wall = heldWall(each, 3 * stiffnessLimit(each.damping, 0, each.period));
    wall.handStiffness = 200;
    EXPECT_LT(workOfAStroke(wall), 0) << "b " << each.damping << ", T " << each.period;
  }
}

/// Whether friction brings the tip to a full stop, whatever force between two steps of the encoder a hand
/// presses with.
bool comesToRest(const VirtualWall& wall) {
  constexpr int kForces = 50;
  for (int i = 0; i < kForces; ++i) {
    const double force = wall.stiffness * wall.encoderStep * (20 + static_cast<double>(i) / kForces);
    const double start = -20.3 * wall.encoderStep;
    auto tip = wall.released(start, start - force / wall.handStiffness);
    bool isStill = true;
    wall.render(tip, [&](int tick, double) {
      if (tick * wall.period > 0.8) isStill = isStill && tip.velocity().norm() == 0;
      return tick * wall.period < 1;
    });
    if (!isStill) return false;
  }
  return true;
}

TEST(VirtualWall, MeasuredLimitOfEncoderStepsIsTwiceFrictionOverStep) {
  for (const double friction : {0.005, 0.02}) {
    for (const double step : {5e-5, 1e-4}) {
      const double theory = quantizationStiffnessLimit(friction, step);
      const double measured = measuredLimit(0.3 * theory, 3 * theory, [&](double K) {
        return comesToRest(
            {.stiffness = K, .damping = 1, .friction = friction, .encoderStep = step, .handStiffness = 1});
      });
      EXPECT_NEAR(measured / theory, 1, 0.05) << "f_c " << friction << ", Delta " << step;
    }
  }
}

}  // namespace
}  // namespace pleura::haptics
