#include <gtest/gtest.h>

#include <pleura/haptics/safety/watchdog.h>

namespace pleura::haptics {
namespace {

constexpr double kTick = 0.001;
constexpr WatchdogRules kRules{.window = 20, .mostMissed = 5, .quietTime = 0.1};
constexpr TickHealth kWell, kLate{.hasMissedDeadline = true}, kNotFinite{.isFinite = false},
    kLost{.hasDevice = false};

/// How many ticks without fault pass until force is back.
int ticksUntilBack(Watchdog& watchdog) {
  for (int tick = 1; tick < 10'000; ++tick)
    if (watchdog.allows(kWell, kTick)) return tick;
  return -1;
}

TEST(Watchdog, AWellLoopKeepsItsForce) {
  Watchdog watchdog(kRules);
  for (int tick = 0; tick < 1000; ++tick) EXPECT_TRUE(watchdog.allows(kWell, kTick));
}

TEST(Watchdog, SomeMissedDeadlinesAreBorne) {
  Watchdog watchdog(kRules);
  // Five in each twenty.
  for (int tick = 0; tick < 1000; ++tick) EXPECT_TRUE(watchdog.allows(tick % 4 == 0 ? kLate : kWell, kTick));
}

TEST(Watchdog, MoreOfThemThanTheRuleBearsTakeTheForce) {
  Watchdog watchdog(kRules);
  for (int tick = 0; tick < 5; ++tick) EXPECT_TRUE(watchdog.allows(kLate, kTick));
  EXPECT_FALSE(watchdog.allows(kLate, kTick));
  EXPECT_EQ(watchdog.fault(), Watchdog::Fault::deadlines);
  // The window has to empty to five, then a quiet time has to pass.
  EXPECT_NEAR(ticksUntilBack(watchdog), 14 + 100, 1);
  EXPECT_EQ(watchdog.fault(), Watchdog::Fault::none);
}

TEST(Watchdog, AWindowOf64IsWhole) {
  Watchdog watchdog({.window = 64, .mostMissed = 63, .quietTime = 0});
  for (int tick = 0; tick < 63; ++tick) EXPECT_TRUE(watchdog.allows(kLate, kTick));
  EXPECT_FALSE(watchdog.allows(kLate, kTick));
  EXPECT_TRUE(watchdog.allows(kWell, kTick));
}

TEST(Watchdog, WhatIsNoNumberTakesTheForceAtOnce) {
  Watchdog watchdog(kRules);
  EXPECT_TRUE(watchdog.allows(kWell, kTick));
  EXPECT_FALSE(watchdog.allows(kNotFinite, kTick));
  EXPECT_EQ(watchdog.fault(), Watchdog::Fault::notFinite);
  EXPECT_NEAR(ticksUntilBack(watchdog), 100, 1);
}

TEST(Watchdog, ALostDeviceGetsItsForceBackAQuietTimeAfterItsReturn) {
  Watchdog watchdog(kRules);
  for (int tick = 0; tick < 500; ++tick) EXPECT_FALSE(watchdog.allows(kLost, kTick));
  EXPECT_EQ(watchdog.fault(), Watchdog::Fault::deviceLost);
  EXPECT_NEAR(ticksUntilBack(watchdog), 100, 1);
}

TEST(Watchdog, AFaultInTheQuietTimeBeginsItAnew) {
  Watchdog watchdog(kRules);
  EXPECT_FALSE(watchdog.allows(kNotFinite, kTick));
  for (int tick = 0; tick < 90; ++tick) EXPECT_FALSE(watchdog.allows(kWell, kTick));
  EXPECT_FALSE(watchdog.allows(kNotFinite, kTick));
  EXPECT_NEAR(ticksUntilBack(watchdog), 100, 1);
}

}  // namespace
}  // namespace pleura::haptics
