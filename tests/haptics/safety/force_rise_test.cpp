#include <gtest/gtest.h>

#include <pleura/haptics/safety/force_rise.h>

namespace pleura::haptics {
namespace {

TEST(ForceRise, RisesFromTheFirstContactOn) {
  ForceRise rise(0.1);
  for (int tick = 0; tick < 1000; ++tick) EXPECT_EQ(rise.gain(false, 0.001), 0);
  EXPECT_EQ(rise.gain(true, 0.001), 0);
  for (int tick = 1; tick <= 100; ++tick) EXPECT_NEAR(rise.gain(true, 0.001), tick * 0.01, 1e-12);
  for (int tick = 0; tick < 100; ++tick) EXPECT_EQ(rise.gain(true, 0.001), 1);
}

TEST(ForceRise, GoesOnWhileNothingIsTouchedAnyMore) {
  ForceRise rise(0.1);
  rise.gain(true, 0.001);
  EXPECT_NEAR(rise.gain(false, 0.05), 0.5, 1e-12);
  EXPECT_EQ(rise.gain(true, 0.05), 1);
}

TEST(ForceRise, StartsAnewWhenForceWasSwitchedOff) {
  ForceRise rise(0.1);
  rise.gain(true, 0.001);
  EXPECT_EQ(rise.gain(true, 1), 1);
  rise.restart();
  EXPECT_EQ(rise.gain(false, 1), 0);
  EXPECT_EQ(rise.gain(true, 1), 0);
  EXPECT_NEAR(rise.gain(true, 0.025), 0.25, 1e-12);
}

}  // namespace
}  // namespace pleura::haptics
