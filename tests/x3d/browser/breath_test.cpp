#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <pleura/tests/x3d/browser/load_scene.h>

namespace pleura {
namespace {

double inflation(Scene& scene) { return valueOf<SFFloat>(scene, "BREATH.inflation"); }

constexpr double kPeriod = 4;  // [s] at 15 breaths a minute

TEST(Breath, InspirationTakesAThirdOfABreath) {
  const auto scene = sceneOfABreath("rate='15' depth='1' style='ONE_TO_TWO'");
  scene->tick(0);
  EXPECT_EQ(inflation(*scene), 0);
  double before = 0;
  for (int k = 1; k <= 1200; ++k) {
    const double t = k * kPeriod / 1200;
    scene->tick(t);
    const double now = inflation(*scene);
    EXPECT_GE((now - before) * (k <= 400 ? 1 : -1), -1e-7) << "at " << t << " s";
    before = now;
  }
  EXPECT_NEAR(before, 0, 1e-6);
  scene->tick(kPeriod + kPeriod / 3);
  EXPECT_NEAR(inflation(*scene), 1, 1e-6);
  scene->tick(kPeriod + kPeriod * 2 / 3);
  EXPECT_NEAR(inflation(*scene), 0.5, 1e-6) << "half of the expiration";
}

TEST(Breath, ASinusoidBreathesInAndOutAlike) {
  const auto scene = sceneOfABreath("rate='15' depth='0.5' style='SINUSOID'");
  for (int k = 0; k <= 100; ++k) {
    const double t = k * kPeriod / 100;
    scene->tick(t);
    EXPECT_NEAR(inflation(*scene), 0.25 * (1 - std::cos(2 * M_PI * t / kPeriod)), 1e-6) << "at " << t << " s";
  }
}

TEST(Breath, GoesOnExactlyWhereItWasPaused) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> any(0.1, 9);
  for (int i = 0; i < 20; ++i) {
    const double pausedAt = any(random), pause = any(random);
    const auto held = sceneOfABreath();
    const auto free = sceneOfABreath();
    for (auto* scene : {held.get(), free.get()}) {
      scene->tick(0);
      scene->tick(pausedAt);
    }
    press(*held, "p");
    for (const double part : {0.2, 0.7, 1.0}) {
      held->tick(pausedAt + part * pause);
      EXPECT_EQ(inflation(*held), inflation(*free)) << "it stands still";
    }
    press(*held, "P");
    for (double t = pausedAt; t < pausedAt + 6; t += 0.13) {
      held->tick(t + pause);
      free->tick(t);
      EXPECT_NEAR(inflation(*held), inflation(*free), 1e-6) << "paused at " << pausedAt << " for " << pause;
    }
  }
}

TEST(Breath, OtherKeysDoNotPause) {
  const auto scene = sceneOfABreath();
  press(*scene, "x");
  EXPECT_FALSE(valueOf<SFBool>(*scene, "BREATH.paused"));
  scene->set("BREATH.pauseKeys=x");
  press(*scene, "x");
  EXPECT_TRUE(valueOf<SFBool>(*scene, "BREATH.paused"));
}

TEST(Breath, AChangeOfRateMakesNoJump) {
  const auto scene = sceneOfABreath("depth='1'");
  scene->tick(0);
  double now = 0, phase = 0;
  for (const char* rate : {"30", "5", "120", "0", "12"}) {
    for (int k = 0; k < 10; ++k) scene->tick(now += 0.037);
    phase = valueOf<SFFloat>(*scene, "BREATH.phase");
    const double before = inflation(*scene);
    scene->set(std::string("BREATH.rate=") + rate);
    EXPECT_EQ(inflation(*scene), before);
    scene->tick(now += 1e-6);
    EXPECT_NEAR(inflation(*scene), before, 1e-4) << "rate " << rate;
    EXPECT_NEAR(valueOf<SFFloat>(*scene, "BREATH.phase"), phase, 1e-4) << "rate " << rate;
  }
}

TEST(Breath, TheNewRateHoldsAtOnce) {
  const auto scene = sceneOfABreath();
  scene->tick(0);
  scene->tick(1);
  const float before = valueOf<SFFloat>(*scene, "BREATH.phase");
  scene->set("BREATH.rate=6");
  scene->tick(2);
  EXPECT_NEAR(valueOf<SFFloat>(*scene, "BREATH.phase") - before, 0.1, 1e-6);
}

TEST(Breath, ANewDepthTakesHoldWithTheNextBreath) {
  const auto changed = sceneOfABreath("depth='0.2'");
  const auto same = sceneOfABreath("depth='0.2'");
  for (auto* scene : {changed.get(), same.get()}) {
    scene->tick(0);
    scene->tick(1);
  }
  changed->set("BREATH.depth=0.8");
  for (double t = 1.1; t < kPeriod; t += 0.1) {
    changed->tick(t);
    same->tick(t);
    EXPECT_EQ(inflation(*changed), inflation(*same)) << "at " << t << " s";
  }
  changed->tick(kPeriod + kPeriod / 3);
  EXPECT_NEAR(inflation(*changed), 0.8, 1e-6);
}

TEST(Breath, ANewStyleTakesHoldWithTheNextBreath) {
  const auto scene = sceneOfABreath("depth='1' style='ONE_TO_TWO'");
  scene->tick(0);
  scene->tick(0.5);
  scene->set("BREATH.style=SINUSOID");
  scene->tick(kPeriod / 3);
  EXPECT_NEAR(inflation(*scene), 1, 1e-6);
  scene->tick(kPeriod + kPeriod / 2);
  EXPECT_NEAR(inflation(*scene), 1, 1e-6);
}

TEST(Breath, AnUnknownStyleIsToldAndTheOldOneStays) {
  const auto scene = sceneOfABreath("style='WILD'");
  EXPECT_EQ(scene->diagnostics().warnings(), 1u);
  scene->tick(0);
  scene->tick(kPeriod / 3);
  EXPECT_NEAR(inflation(*scene), 1. / 7, 1e-6);
}

TEST(Breath, DoesNotDependOnHowOftenItIsTicked) {
  const auto often = sceneOfABreath();
  const auto seldom = sceneOfABreath();
  for (int k = 0; k <= 1000; ++k) often->tick(k * 0.01);
  seldom->tick(0);
  seldom->tick(1000 * 0.01);
  EXPECT_EQ(inflation(*often), inflation(*seldom));
}

TEST(Breath, AMillionStepsLaterARibIsWhereItWasInTheFirstBreath) {
  const auto scene = sceneOf(
      "<ImportLibrary library='\"thorax\"'/><Respiration DEF='BREATH' rate='15' depth='1'/>"
      "<RotTransform DEF='RIB' angles='0.25 0.24 1' center='0.0157 0.1631 -0.0279' points='0.0375 0.1012 "
      "0.0578'/>"
      "<ROUTE fromNode='BREATH' fromField='inflation' toNode='RIB' toField='inflation'/>");
  constexpr int kBreath = 1000, kSteps = 1'000'000;  // ticks
  auto& points = dynamic_cast<MFVec3f&>(scene->field("RIB.rib_points"));
  const Vec3f joint(0.0157f, 0.1631f, -0.0279f);
  std::vector<Vec3f> first;
  float drift = 0, stretch = 0;
  for (int k = 0; k < kSteps; ++k) {
    scene->tick(k * (kPeriod / kBreath));
    const Vec3f tip = points.getValue()[0];
    if (k < kBreath) first.push_back(tip);
    const Vec3f& then = first[static_cast<std::size_t>(k % kBreath)];
    drift = std::max(drift, (tip - then).norm());
    stretch = std::max(stretch, std::abs((tip - joint).norm() - (first[0] - joint).norm()));
  }
  EXPECT_LT(drift, 1e-7) << "m from breath 1";
  EXPECT_LT(stretch, 1e-7) << "m of the rib's length";
}

TEST(Breath, TenThousandPausesLoseNoTime) {
  const auto scene = sceneOfABreath("depth='1'");
  std::mt19937 random(21);
  std::uniform_real_distribution<double> some(0.01, 0.5);
  scene->tick(0);
  double now = 0, breathed = 0;  // [s]
  for (int i = 0; i < 10'000; ++i) {
    const double breathing = some(random);
    scene->tick(now += breathing);
    breathed += breathing;
    press(*scene, "p");
    scene->tick(now += some(random));
    press(*scene, "p");
  }
  const double breaths = breathed / kPeriod;
  EXPECT_NEAR(valueOf<SFFloat>(*scene, "BREATH.phase"), breaths - std::floor(breaths), 1e-6);
}

TEST(Breath, AtRateZeroNothingMoves) {
  const auto scene = sceneOfABreath("rate='0'");
  for (int k = 0; k < 10; ++k) scene->tick(k);
  EXPECT_EQ(inflation(*scene), 0);
}

}  // namespace
}  // namespace pleura
