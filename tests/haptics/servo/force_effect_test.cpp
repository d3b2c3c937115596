#include <numbers>

#include <gtest/gtest.h>

#include <pleura/haptics/servo/force_effect.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;

constexpr double kNow = 0;
const Vector3d kStill = Vector3d::Zero();

TEST(ForceEffect, ASpringCatchesHoldsAndLetsGo) {
  const ForceEffect spring{.kind = SpringForce{.position = {1, 0, 0},
                                               .stiffness = 100,
                                               .damping = 2,
                                               .startDistance = 0.01,
                                               .escapeDistance = 0.03}};
  bool isActive = false;
  EXPECT_EQ(forceOf(spring, {0.98, 0, 0}, kStill, kNow, isActive), kStill) << "too far to be caught";
  EXPECT_FALSE(isActive);
  EXPECT_NEAR(forceOf(spring, {0.995, 0, 0}, kStill, kNow, isActive).x(), 0.5, 1e-12);
  EXPECT_TRUE(isActive);
  EXPECT_NEAR(forceOf(spring, {0.98, 0, 0}, {0.1, 0, 0}, kNow, isActive).x(), 2 - 0.2, 1e-12);
  EXPECT_TRUE(isActive) << "held farther than it was caught";
  EXPECT_EQ(forceOf(spring, {0.96, 0, 0}, kStill, kNow, isActive), kStill);
  EXPECT_FALSE(isActive);
}

TEST(ForceEffect, DragIsAgainstTheMotion) {
  bool isActive = false;
  const ForceEffect drag{.kind = ViscousForce{0.5}};
  EXPECT_EQ(forceOf(drag, kStill, {0, 2, 0}, kNow, isActive), Vector3d(0, -1, 0));
}

TEST(ForceEffect, AWaveGoesWithTime) {
  bool isActive = false;
  const ForceEffect wave{.kind = PeriodicForce{.amplitude = {1, 2, 0},
                                               .frequency = {50, 0, 0},
                                               .phase = {0, std::numbers::pi / 2, 0}}};
  const Vector3d atQuarter = forceOf(wave, kStill, kStill, 0.005, isActive);
  EXPECT_NEAR(atQuarter.x(), 1, 1e-12);
  EXPECT_NEAR(atQuarter.y(), 2, 1e-12);
}

TEST(ForceEffect, NothingIsStifferThanTheDeviceHolds) {
  const auto spring = atMost({.kind = SpringForce{.stiffness = 1e6, .damping = 50}}, 400, 0.2);
  EXPECT_EQ(std::get<SpringForce>(spring.kind).stiffness, 400);
  EXPECT_EQ(std::get<SpringForce>(spring.kind).damping, 0.2);
  EXPECT_EQ(std::get<ViscousForce>(atMost({.kind = ViscousForce{3}}, 400, 0.2).kind).coefficient, 0.2);
}

}  // namespace
}  // namespace pleura::haptics
