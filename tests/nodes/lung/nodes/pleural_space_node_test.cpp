#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/lung/mechanics/respiratory_units.h>
#include <pleura/nodes/thorax/deformable_shape2.h>
#include <pleura/tests/nodes/lung/nodes/lung_scene.h>

namespace pleura {
namespace {

/// The pleural spaces of a scene over time.
class PleuralSpaceNode : public ::testing::Test {
 protected:
  void load(const std::filesystem::path& anatomy = {}) {
    scene = pneumothoraxScene(anatomy);
    scene->tick(0);
  }
  double number(const std::string& field) { return valueOf<SFFloat>(*scene, field); }
  template <class See>
  void run(double until, See see) {
    runOn(*scene, now, until, see);
  }
  void run(double until) {
    run(until, [&] { number("PLEURA_L.lungVolume"); });
  }
  double volume(const std::string& organ) {
    auto& shape = dynamic_cast<DeformableShape2&>(scene->node(organ));
    return signedVolume(shape.deformedCoord.getValue(), shape.rest().triangles);
  }
  void expectNoDiagnostics() {
    for (const auto& each : scene->diagnostics().all()) ADD_FAILURE() << toText(each);
  }
  void expectQuietBreath();

  std::unique_ptr<Scene> scene;
  double now = 0;
};

void PleuralSpaceNode::expectQuietBreath() {
  double lowest = 0, highest = -1e9, least = 1e9, most = -1e9, smallest = 1e9, largest = 0;
  run(8, [&] {
    if (now < 4) return;
    for (const char* side : {"PLEURA_L", "PLEURA_R"}) {
      const double p = number(side + std::string(".intrapleuralPressure")) / kCmH2O;
      const double alveolar = number(side + std::string(".alveolarPressure")) / kCmH2O;
      lowest = std::min(lowest, p);
      highest = std::max(highest, p);
      least = std::min(least, alveolar);
      most = std::max(most, alveolar);
    }
    const double both = number("PLEURA_L.lungVolume") + number("PLEURA_R.lungVolume");
    smallest = std::min(smallest, both);
    largest = std::max(largest, both);
  });
  // Guyton has -5 to -7.5 cmH2O; while air flows in, resistance adds to recoil.
  EXPECT_NEAR(highest, -5.0, 0.1);
  EXPECT_GT(lowest, -8.2);
  EXPECT_LT(lowest, -6.5);
  EXPECT_GT(least, -1.8) << "cmH2O (Otis 1947)";
  EXPECT_LT(most, 1.8);
  EXPECT_LT(least, -0.3);
  EXPECT_GE(largest - smallest, 0.4e-3) << "m^3";
  EXPECT_LE(largest - smallest, 0.6e-3);
  expectNoDiagnostics();
}

TEST_F(PleuralSpaceNode, QuietBreathHasTheMeasuredPressures) {
  load();
  expectQuietBreath();
}

TEST_F(PleuralSpaceNode, WithoutGasTheLungIsWhatTheContactsSay) {
  load();
  const auto bare = breathingThorax();
  run(2);
  bare->tick(now);
  EXPECT_EQ(valueOf<MFVec3f>(*scene, "LUNG_L.deformedCoord"),
            valueOf<MFVec3f>(*bare, "LUNG_L.deformedCoord"));
  EXPECT_NEAR(number("PLEURA_L.lungVolume"), volume("LUNG_L"), 1e-6);
}

TEST_F(PleuralSpaceNode, AnOpenWoundLetsItsLungCollapseAndTheDrainDrawsItOut) {
  load();
  run(4);
  const double before = number("PLEURA_L.lungVolume");
  scene->set("PLEURA_L.pneumothorax=OPEN");
  run(12);
  EXPECT_NEAR(number("PLEURA_L.intrapleuralPressure"), 0, 0.2 * kCmH2O);
  EXPECT_LT(number("PLEURA_L.lungVolume"), 0.75 * before);
  EXPECT_NEAR(volume("LUNG_L"), number("PLEURA_L.lungVolume"), 2e-5) << "what is seen is what is told";
  EXPECT_LT(number("PLEURA_R.intrapleuralPressure"), -4.5 * kCmH2O) << "the other lung breathes on";
  scene->set("PLEURA_L.pneumothorax=NONE");
  run(16);
  EXPECT_GT(number("PLEURA_L.pleuralGas"), 1e-4) << "a closed wound keeps its gas";
  scene->set("PLEURA_L.drain=true");
  run(24);
  EXPECT_LT(number("PLEURA_L.pleuralGas"), 1e-6);
  EXPECT_NEAR(number("PLEURA_L.lungVolume"), before, 2e-6) << "at the same moment of the breath";
  expectNoDiagnostics();
}

TEST_F(PleuralSpaceNode, AFreedLungStaysInItsCavity) {
  load();
  scene->set("PLEURA_L.pneumothorax=OPEN");
  auto& lung = dynamic_cast<DeformableShape2&>(scene->node("LUNG_L"));
  double deepest = 0, widest = 0;
  run(6, [&] {
    if (std::fmod(now, 0.5) > kTick) return;
    const auto cavity = valueOf<MFVec3f>(*scene, "LUNG_L_CONTACTS.shape");
    const SurfaceQuery wall(cavity, lung.rest().triangles);
    for (const Vec3f& point : lung.deformedCoord.getValue()) {
      const double outside = wall.signedDistance(point.cast<double>());
      deepest = std::max(deepest, outside);
      widest = std::max(widest, -outside);
    }
  });
  EXPECT_LT(deepest, 1e-3) << "m through the wall";
  EXPECT_GT(widest, 1e-2) << "m from the wall: it has collapsed";
}

TEST_F(PleuralSpaceNode, ATensionPneumothoraxRisesAboveAtmosphericPressure) {
  load();
  scene->set("PLEURA_L.pneumothorax=TENSION");
  double highest = -1e9;
  run(12, [&] { highest = std::max(highest, number("PLEURA_L.intrapleuralPressure")); });
  EXPECT_GT(highest, 0.5 * kCmH2O);
}

TEST_F(PleuralSpaceNode, AClosedPneumothoraxKeepsItsGas) {
  load();
  scene->set("PLEURA_L.gasVolume=3e-4");
  scene->set("PLEURA_L.pneumothorax=CLOSED");
  run(3);
  const double early = number("PLEURA_L.pleuralGas");
  run(11);
  EXPECT_NEAR(early, 3e-4, 1e-5);
  EXPECT_NEAR(number("PLEURA_L.pleuralGas"), early, 1e-6);
}

TEST_F(PleuralSpaceNode, AChangeCountsFromItsMomentThoughNobodyLooks) {
  load();
  const auto collapsed = [](bool isLookedAt) {
    auto other = pneumothoraxScene();
    other->tick(0);
    double time = 0;
    const auto look = [&] {
      if (isLookedAt) valueOf<SFFloat>(*other, "PLEURA_L.lungVolume");
    };
    valueOf<SFFloat>(*other, "PLEURA_L.lungVolume");  // from here on it has a past
    other->set("BREATH.paused=true");
    runOn(*other, time, 2, look);
    other->set("PLEURA_L.pneumothorax=OPEN");
    runOn(*other, time, 2.4, look);
    return valueOf<SFFloat>(*other, "PLEURA_L.lungVolume");
  };
  EXPECT_NEAR(collapsed(false), collapsed(true), 1e-5);
}

TEST_F(PleuralSpaceNode, PausedThePressuresComeToRest) {
  load();
  run(1);
  scene->set("BREATH.paused=true");
  run(4);
  const double volume = number("PLEURA_L.lungVolume");
  EXPECT_NEAR(number("PLEURA_L.alveolarPressure"), 0, 0.01 * kCmH2O);
  run(8);
  EXPECT_NEAR(number("PLEURA_L.lungVolume"), volume, 1e-9);
}

TEST_F(PleuralSpaceNode, UnknownKindsAreTold) {
  load();
  scene->set("PLEURA_L.pneumothorax=SOME");
  run(0.1);
  ASSERT_FALSE(scene->diagnostics().all().empty());
  EXPECT_THAT(scene->diagnostics().all()[0].message,
              testing::HasSubstr("PLEURA_L: pneumothorax is NONE, CLOSED, OPEN or TENSION, not SOME"));
}

TEST_F(PleuralSpaceNode, LabelsAreReadByPeople) {
  load();
  run(4);
  EXPECT_THAT(
      valueOf<MFString>(*scene, "PLEURA_L.label"),
      testing::ElementsAre("intrapleural -5.0 cmH2O", testing::StartsWith("alveolar "),
                           testing::StartsWith("transpulmonary +5.0 cmH2O"),
                           testing::MatchesRegex("lung 1[0-9]+ mL"), testing::StartsWith("air flow ")));
}

TEST_F(PleuralSpaceNode, TwoRunsAreTheSameBitForBit) {
  const auto shape = [] {
    auto run = pneumothoraxScene();
    run->tick(0);
    double time = 0;
    run->set("PLEURA_L.pneumothorax=OPEN");
    runOn(*run, time, 1, [&] { valueOf<SFFloat>(*run, "PLEURA_L.lungVolume"); });
    return valueOf<MFVec3f>(*run, "LUNG_L.deformedCoord");
  };
  EXPECT_EQ(shape(), shape());
}

TEST_F(PleuralSpaceNode, WhatNobodyAsksForIsNotSolved) {
  load();
  const auto built = [&] { return valueOf<MFVec3f>(*scene, "PLEURA_L.point").size(); };
  EXPECT_EQ(built(), 0u) << "no gas, no freed lung";
}

/// A whole breath in which each sentence's sign is that of the numbers.
TEST_F(PleuralSpaceNode, TheCausalChainTellsTheBreath) {
  load();
  const auto changes = [&] { return valueOf<MFInt32>(*scene, "WHY.change"); };
  enum { muscle, cavity, intrapleural, transpulmonary, lungVolume };
  int agreeing = 0;
  double before = number("PLEURA_L.lungVolume");
  run(8, [&] {
    const auto change = changes();
    ASSERT_EQ(change.size(), 7u);
    const double volume = number("PLEURA_L.lungVolume");
    if (std::abs(volume - before) > 1e-6) {
      EXPECT_EQ(change[lungVolume], volume > before ? 1 : -1) << now;
      EXPECT_EQ(change[cavity], change[lungVolume]) << now;
      ++agreeing;
    }
    before = volume;
  });
  EXPECT_GT(agreeing, 150);
  run(8.6);
  EXPECT_THAT(valueOf<MFString>(*scene, "WHY.text"),
              testing::Contains(testing::HasSubstr("because the breathing muscles pull harder")));
}

}  // namespace
}  // namespace pleura
