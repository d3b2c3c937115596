#include <gtest/gtest.h>

#include <pleura/tests/nodes/chain/chain_scene.h>

namespace pleura {
namespace {

constexpr double kStep = 1.0 / 32;  // [s], exact in binary: times differ by nothing but the pause

/// All that breathes: the shapes, and a rib.
std::string stateOf(Scene& scene) {
  std::string state = scene.field("LEFT RIB5.rotation").getValueAsString();
  for (const auto* organ : {"deformableDiaph", "deformableLL", "deformableRL"})
    state += scene.field(std::string(organ) + ".deformedCoord").getValueAsString();
  return state;
}

void run(Scene& scene, int from, int to) {
  for (int k = from; k <= to; ++k) scene.tick(k * kStep);
}

TEST(ChainPause, AKeyPausesAndResumesWithoutAJump) {
  const auto paused = chainThorax();
  const auto running = chainThorax();
  run(*paused, 0, 20);
  run(*running, 0, 20);
  const std::string before = stateOf(*paused);
  ASSERT_EQ(before, stateOf(*running));

  pressActionKey(*paused, 1);
  EXPECT_EQ(valueOf<SFTime>(*paused, "deformableDiaph.pause_time"), 20 * kStep);
  for (int k = 21; k <= 50; ++k) {
    paused->tick(k * kStep);
    ASSERT_TRUE(stateOf(*paused) == before) << "moves while paused, at step " << k;
  }
  pressActionKey(*paused, 1);
  EXPECT_EQ(valueOf<SFTime>(*paused, "deformableLL.resume_time"), 50 * kStep);

  std::string seen = before;
  for (int k = 1; k <= 40; ++k) {
    paused->tick((50 + k) * kStep);
    running->tick((20 + k) * kStep);
    const std::string now = stateOf(*paused);
    ASSERT_TRUE(now == stateOf(*running)) << "not the unpaused breath shifted in time, at step " << k;
    ASSERT_FALSE(now == seen);
    seen = now;
  }
}

TEST(ChainPause, EveryClockPauses) {
  const auto scene = chainThorax();
  run(*scene, 0, 3);
  pressActionKey(*scene, 18);
  run(*scene, 4, 5);
  for (const auto* clock : {"TS", "timeDiaph", "timeLL", "timeRL"})
    EXPECT_TRUE(valueOf<SFBool>(*scene, clock + std::string(".isPaused"))) << clock;
}

TEST(ChainPause, TwoKeysBetweenTicksLeaveItRunning) {
  const auto scene = chainThorax();
  const auto running = chainThorax();
  run(*scene, 0, 10);
  pressActionKey(*scene, 1);
  pressActionKey(*scene, 1);
  run(*scene, 11, 20);
  run(*running, 0, 20);
  EXPECT_FALSE(valueOf<SFBool>(*scene, "TS.isPaused"));
  const auto rib = valueOf<SFRotation>(*scene, "LEFT RIB5.rotation");
  EXPECT_NEAR(rib.angle, valueOf<SFRotation>(*running, "LEFT RIB5.rotation").angle, 1e-5)
      << "a microsecond late";
  pressActionKey(*scene, 1);
  run(*scene, 21, 22);
  EXPECT_TRUE(valueOf<SFBool>(*scene, "TS.isPaused")) << "the next key pauses again";
}

TEST(ChainPause, ACharacterKeyServesAsWell) {
  const auto scene = chainThorax();
  run(*scene, 0, 3);
  scene->key({.character = "p"});
  run(*scene, 4, 5);
  EXPECT_TRUE(valueOf<SFBool>(*scene, "TS.isPaused"));
}

}  // namespace
}  // namespace pleura
