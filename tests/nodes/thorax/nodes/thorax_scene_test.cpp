#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/tests/nodes/thorax/nodes/thorax_scene.h>
#include <pleura/tests/x3d/temporary_folder.h>
#include <pleura/x3d/browser/scene/state_hash.h>

namespace pleura {
namespace {

constexpr double kPeriod = 4;  // [s] at the scene's 15 breaths a minute

/// How far lung volume [m^3] and dome [m] swing in a breath.
struct Swings {
  double volume = 0, dome = 0;
};

Swings breathe(float depth) {
  const auto scene = breathingThorax();
  scene->set("BREATH.depth=" + std::to_string(depth));
  scene->set("BREATH.rate=15");
  double leastVolume = 1e9, mostVolume = -1e9, lowest = 1e9, highest = -1e9;
  constexpr int kTicks = 24;
  for (int k = 0; k <= kTicks; ++k) {
    scene->tick(k * kPeriod / kTicks);
    const double volume = valueOf<SFFloat>(*scene, "BREATH.lungVolume");
    const double dome = valueOf<SFFloat>(*scene, "BREATH.domeHeight");
    leastVolume = std::min(leastVolume, volume);
    mostVolume = std::max(mostVolume, volume);
    lowest = std::min(lowest, dome);
    highest = std::max(highest, dome);
  }
  return {mostVolume - leastVolume, highest - lowest};
}

double farthestFromRest(Scene& scene, const std::string& organ) {
  const auto rest = valueOf<MFVec3f>(scene, organ + ".origCoord");
  const auto now = valueOf<MFVec3f>(scene, organ + ".deformedCoord");
  EXPECT_EQ(rest.size(), now.size());
  float farthest = 0;
  for (std::size_t i = 0; i < std::min(rest.size(), now.size()); ++i)
    farthest = std::max(farthest, (now[i] - rest[i]).norm());
  return farthest;
}

TEST(ThoraxScene, LoadsWithoutFault) {
  const auto scene = breathingThorax();
  for (const auto& each : scene->diagnostics().all()) ADD_FAILURE() << toText(each);
}

TEST(ThoraxScene, QuietBreath) {
  const Swings quiet = breathe(1.f / 7);
  EXPECT_GE(quiet.volume, 0.4e-3) << "m^3; about half a litre (Boron 2017)";
  EXPECT_LE(quiet.volume, 0.6e-3);
  EXPECT_GE(quiet.dome, 0.8e-2) << "m";
  EXPECT_LE(quiet.dome, 2.1e-2);
}

TEST(ThoraxScene, BreathToTotalLungCapacity) {
  const Swings deep = breathe(1);
  EXPECT_GE(deep.volume, 2.5e-3) << "m^3";
  EXPECT_LE(deep.volume, 4e-3);
  EXPECT_GE(deep.dome, 5e-2) << "m";
  EXPECT_LE(deep.dome, 8.6e-2);
}

TEST(ThoraxScene, VolumeRisesWithInflationThroughoutInspiration) {
  const auto scene = breathingThorax();
  scene->set("BREATH.depth=1");
  double before = 0;
  for (int k = 0; k <= 12; ++k) {
    scene->tick(k * kPeriod / 3 / 12);
    const double volume = valueOf<SFFloat>(*scene, "BREATH.lungVolume");
    EXPECT_GE(volume, before) << "at " << k << "/12 of inspiration";
    before = volume;
  }
}

TEST(ThoraxScene, ExhaleReturnsToRest) {
  const auto scene = breathingThorax();
  scene->set("BREATH.depth=1");
  scene->tick(0);
  scene->tick(kPeriod / 3);
  for (const char* organ : {"LUNG_L", "LUNG_R", "DIAPHRAGM"})
    EXPECT_GT(farthestFromRest(*scene, organ), 1e-2) << organ << " at the top of the breath";
  scene->tick(kPeriod);
  for (const char* organ : {"LUNG_L", "LUNG_R", "DIAPHRAGM"})
    EXPECT_LE(farthestFromRest(*scene, organ), 1e-6) << organ;
}

TEST(ThoraxScene, TheShapeDoesNotDependOnTheWayThere) {
  const auto straight = breathingThorax();
  const auto roundabout = breathingThorax();
  for (auto* scene : {straight.get(), roundabout.get()}) scene->tick(0);
  for (const double t : {0.4, 1.1, 1.9, 3.0}) {
    roundabout->tick(t);
    valueOf<SFFloat>(*roundabout, "BREATH.lungVolume");
  }
  for (auto* scene : {straight.get(), roundabout.get()}) scene->tick(kPeriod + 1);
  EXPECT_EQ(valueOf<MFVec3f>(*straight, "LUNG_L.deformedCoord"),
            valueOf<MFVec3f>(*roundabout, "LUNG_L.deformedCoord"));
}

TEST(ThoraxScene, TwoRunsAreTheSameBitForBit) {
  const auto run = [] {
    const auto scene = breathingThorax();
    for (int k = 0; k < 5; ++k) scene->tick(k * 0.3);
    return stateHash(*scene);
  };
  EXPECT_EQ(run(), run());
}

/// A whole thorax in whose file stands `more`.
std::unique_ptr<Scene> thoraxWith(const std::string& more) {
  const TemporaryFolder folder;
  auto scene = std::make_unique<Scene>();
  ReaderLimits limits;
  limits.outsideFolder = true;
  scene->load(
      folder.write("s.x3d", "<Scene><ImportLibrary library='\"thorax\"'/><Inline DEF='BREATHING' url='\"" +
                                (sceneFolder() / "breathing_thorax.x3d").string() +
                                "\"'/>"
                                "<IMPORT inlineDEF='BREATHING' importedDEF='BREATH'/>"
                                "<IMPORT inlineDEF='BREATHING' importedDEF='LUNG_L'/>"
                                "<IMPORT inlineDEF='BREATHING' importedDEF='LUNG_L_CONTACTS'/>" +
                                more + "</Scene>"),
      limits);
  return scene;
}

TEST(ThoraxScene, AnOrganDeformsAsItsSceneSays) {
  const auto byDefault = thoraxWith("");
  const auto chosen = thoraxWith(
      "<OrganDeformation><LungContacts USE='LUNG_L_CONTACTS' containerField='contacts'/>"
      "<ChainmailDeformer smoothing='20'/></OrganDeformation>");
  for (auto* scene : {byDefault.get(), chosen.get()}) {
    for (const auto& each : scene->diagnostics().all()) ADD_FAILURE() << toText(each);
    scene->set("BREATH.depth=1");
    scene->tick(0);
    scene->tick(kPeriod / 3);
  }
  const auto filled = valueOf<MFVec3f>(*byDefault, "LUNG_L.deformedCoord");
  const auto deformed = valueOf<MFVec3f>(*chosen, "LUNG_L.deformedCoord");
  const auto held = valueOf<MFInt32>(*chosen, "LUNG_L_CONTACTS.index");
  ASSERT_EQ(filled.size(), deformed.size());
  EXPECT_LT(held.size(), filled.size());
  for (const int point : held)
    EXPECT_EQ(deformed[static_cast<std::size_t>(point)], filled[static_cast<std::size_t>(point)]);
  int differing = 0;
  for (std::size_t i = 0; i < filled.size(); ++i) differing += filled[i] != deformed[i] ? 1 : 0;
  EXPECT_GT(differing, static_cast<int>(filled.size() - held.size()) / 2);
}

TEST(ThoraxScene, AnOrganDeformationWithoutContactsIsTold) {
  const auto scene = thoraxWith("<OrganDeformation DEF='NONE'><ChainmailDeformer/></OrganDeformation>");
  ASSERT_EQ(scene->diagnostics().all().size(), 1u);
  EXPECT_THAT(scene->diagnostics().all()[0].message, testing::HasSubstr("NONE: contacts is missing"));
}

TEST(ThoraxScene, RibsTurnWithTheBreath) {
  const auto scene = breathingThorax();
  scene->set("BREATH.depth=1");
  scene->tick(0);
  EXPECT_NEAR(valueOf<SFRotation>(*scene, "RIB_L5.rotation").angle, 0, 1e-6);
  scene->tick(kPeriod / 3);
  EXPECT_GT(valueOf<SFRotation>(*scene, "RIB_L5.rotation").angle, 0.1);
}

}  // namespace
}  // namespace pleura
