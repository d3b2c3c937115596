#include <fstream>

#include "touched_scene.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/haptics/device/haptic_device.h>

namespace pleura {
namespace {

using testing::HasSubstr;

constexpr auto kSmooth = "<SmoothSurface stiffness='0.5'/>";

TEST(TouchSession, ATouchIsToldByDeviceAndGeometry) {
  const auto scene = sceneOf(blockAndStylus(kSmooth, 0.005));
  Playback playback(*scene, {});
  playback.runUntil(0.5);
  EXPECT_TRUE(valueOf<MFBool>(*scene, "BOX.isTouched").empty()) << "nobody touched it so far";
  EXPECT_EQ(valueOf<SFString>(*scene, "STYLUS.touched"), "");
  playback.runUntil(2);
  EXPECT_EQ(valueOf<SFString>(*scene, "STYLUS.touched"), "BLOCK");
  EXPECT_EQ(valueOf<MFBool>(*scene, "BOX.isTouched"), std::vector<bool>{true});
  const float depth = valueOf<SFFloat>(*scene, "STYLUS.depth");
  EXPECT_NEAR(depth, 0.005 * 5000 / (5000 + 200), 2e-4) << "hand and surface in series";
  EXPECT_NEAR(valueOf<SFVec3f>(*scene, "STYLUS.force").z(), 200 * depth, 1e-3);
  EXPECT_NEAR(valueOf<MFFloat>(*scene, "BOX.contactDepth").at(0), depth, 1e-6);
  EXPECT_NEAR((valueOf<MFVec3f>(*scene, "BOX.contactPoint").at(0) - Vec3f(0, 0, 0.1f)).norm(), 0, 1e-3)
      << "in the box's own frame";
  EXPECT_NEAR((valueOf<MFVec3f>(*scene, "BOX.contactNormal").at(0) - Vec3f::UnitZ()).norm(), 0, 1e-6);
  EXPECT_NEAR(valueOf<MFVec3f>(*scene, "BOX.force").at(0).z(), 200 * depth, 1e-3);
  EXPECT_NEAR(valueOf<SFVec3f>(*scene, "STYLUS.proxyPosition").z(), 0.0025, 1e-6);
  EXPECT_TRUE(valueOf<SFBool>(*scene, "STYLUS.isConnected"));
  EXPECT_EQ(valueOf<SFInt32>(*scene, "STYLUS.hapticsRate"), 1000);
}

TEST(TouchSession, ATouchEnds) {
  const auto scene = sceneOf(
      "<Shape><Appearance><SmoothSurface/></Appearance><Box DEF='BOX' size='0.02 0.02 0.02'/></Shape>"
      "<DeviceInfo><SimulatedDevice DEF='STYLUS' key='0 1 2 3' keyValue='0 0 0.05 0 0 0.01 0 0 0.01 0 0 "
      "0.05'/>"
      "</DeviceInfo>");
  Playback playback(*scene, {});
  playback.runUntil(2);
  EXPECT_EQ(valueOf<MFBool>(*scene, "BOX.isTouched"), std::vector<bool>{true});
  playback.runUntil(3);
  EXPECT_EQ(valueOf<MFBool>(*scene, "BOX.isTouched"), std::vector<bool>{false});
  EXPECT_EQ(valueOf<MFFloat>(*scene, "BOX.contactDepth"), std::vector<float>{0});
  EXPECT_EQ(valueOf<SFVec3f>(*scene, "STYLUS.force"), Vec3f(Vec3f::Zero()));
  EXPECT_EQ(valueOf<SFString>(*scene, "STYLUS.touched"), "");
}

TEST(TouchSession, TheSameSessionGivesTheSameBits) {
  const auto forces = [](double step) {
    const auto scene = sceneOf(blockAndStylus("<FrictionalSurface stiffness='1'/>", 0.003));
    Playback playback(*scene, {.step = step});
    std::vector<Vec3f> all;
    playback.runUntil(1.5, [&](Time) { all.push_back(valueOf<SFVec3f>(*scene, "STYLUS.force")); });
    return all;
  };
  EXPECT_EQ(forces(1.0 / 30), forces(1.0 / 30));
  EXPECT_EQ(forces(0.01).back(), forces(0.05).back())
      << "how often the scene ticks is not felt on what stands still";
}

TEST(TouchSession, ASceneWithoutADeviceOrWithoutSurfacesBuildsNoTree) {
  for (const std::string scene :
       {"<Shape><Appearance><SmoothSurface/></Appearance><Box/></Shape>",
        "<DeviceInfo><SimulatedDevice/></DeviceInfo><Shape><Appearance/><Box/></Shape>",
        "<DeviceInfo><SimulatedDevice/></DeviceInfo><Switch "
        "whichChoice='-1'><Shape><Appearance><SmoothSurface/>"
        "</Appearance><Box/></Shape></Switch>"}) {
    const auto loaded = sceneOf(scene);
    Playback playback(*loaded, {});
    playback.runUntil(0.1);
    EXPECT_EQ(playback.touch().statistics().treesBuilt, 0u) << scene;
  }
}

TEST(TouchSession, WhatDoesNotMoveIsFittedOnceABuffer) {
  const auto scene = sceneOf(blockAndStylus(kSmooth, 0.005));
  Playback playback(*scene, {});
  playback.runUntil(2);
  EXPECT_EQ(playback.touch().statistics().treesBuilt, 1u);
  EXPECT_LE(playback.touch().statistics().treesRefitted, 4u);
}

TEST(TouchSession, AnAskedDeviceStandsInWhereTheSceneHasNone) {
  const TemporaryFolder folder;
  const auto path = folder.write("path.csv", "time,x,y,z\n0,0,0,0.05\n1,0,0,0.0\n");
  const auto scene =
      sceneOf("<Shape DEF='BALL'><Appearance><SmoothSurface/></Appearance><Sphere radius='0.02'/></Shape>");
  Playback playback(*scene, {.watch = {"STYLUS.force"}, .touch = {.stylus = path}});
  playback.runUntil(2);
  EXPECT_EQ(valueOf<SFString>(*scene, "STYLUS.touched"), "BALL");
  EXPECT_GT(valueOf<SFVec3f>(*scene, "STYLUS.force").z(), 0.5f);
}

TEST(TouchSession, AnAskedPathTakesThePlaceOfTheScenes) {
  const TemporaryFolder folder;
  const auto path = folder.write("path.csv", "0,0.3,0,0\n");
  const auto scene = sceneOf(blockAndStylus(kSmooth, 0.005));
  Playback playback(*scene, {.touch = {.device = "simulated", .stylus = path}});
  playback.runUntil(2);
  EXPECT_NEAR(valueOf<SFVec3f>(*scene, "STYLUS.trackerPosition").x(), 0.25, 1e-3)
      << "as far as the device reaches";
  EXPECT_EQ(valueOf<SFString>(*scene, "STYLUS.touched"), "");
}

TEST(TouchSession, WhatIsAskedForAndNotThereIsAnError) {
  const auto scene = sceneOf("<Group/>");
  try {
    Playback playback(*scene, {.touch = {.device = "simulatd"}});
    FAIL();
  } catch (const std::invalid_argument& unknown) {
    EXPECT_THAT(unknown.what(), HasSubstr("simulatd"));
    EXPECT_THAT(unknown.what(), HasSubstr("did you mean simulated?"));
  }
  EXPECT_THROW(Playback(*scene, {.touch = {.stylus = "/not/there.csv"}}), haptics::DeviceError);
  EXPECT_THROW(Playback(*scene, {.touch = {.record = "/not/there/recording"}}), haptics::DeviceError);
}

TEST(TouchSession, WhatTheSceneSaysWrongIsAWarningAndTheRestGoesOn) {
  for (const auto& [device, expected] : std::vector<std::pair<std::string, std::string>>{
           {"<SimulatedDevice DEF='STYLUS' model='Omnni'/>", "did you mean Omni?"},
           {"<SimulatedDevice DEF='STYLUS' key='0 1' keyValue='0 0 0'/>",
            "2 values of key, but 1 of keyValue"},
           {"<SimulatedDevice DEF='STYLUS' url='\"missing.csv\"'/>", "missing.csv"},
           {"<SimulatedDevice DEF='STYLUS' url='\"../../etc/passwd\"'/>", "outside the scene's folder"},
           {"<SimulatedDevice DEF='STYLUS' mass='0'/>", "mass"}}) {
    const auto scene =
        sceneOf("<DeviceInfo>" + device + "</DeviceInfo><TimeSensor DEF='CLOCK' loop='true'/>");
    Playback playback(*scene, {});
    playback.runUntil(0.2);
    ASSERT_EQ(scene->diagnostics().all().size(), 1u) << device;
    EXPECT_THAT(scene->diagnostics().all()[0].message, HasSubstr("STYLUS")) << device;
    EXPECT_THAT(scene->diagnostics().all()[0].message, HasSubstr(expected)) << device;
    EXPECT_FALSE(valueOf<SFBool>(*scene, "STYLUS.isConnected"));
    EXPECT_NEAR(valueOf<SFTime>(*scene, "CLOCK.time"), 0.2, 1e-9);
  }
}

TEST(TouchSession, WhatNoDeviceCanBeIsToldWhereNobodyOpensIt) {
  for (const char* bad : {"model='Omnni'", "key='0 1' keyValue='0 0 0'"}) {
    const auto scene =
        sceneOf(std::string("<DeviceInfo><SimulatedDevice DEF='STYLUS' ") + bad + "/></DeviceInfo>");
    EXPECT_EQ(scene->diagnostics().warnings(), 1u) << bad;
  }
}

TEST(TouchSession, ADeadmansSwitchHoldsTheForceBack) {
  const auto scene = sceneOf(blockAndStylus(kSmooth, 0.005, "deadmansSwitch='true'"));
  Playback playback(*scene, {});
  playback.runUntil(2);
  EXPECT_EQ(valueOf<SFVec3f>(*scene, "STYLUS.force"), Vec3f(Vec3f::Zero()));
  EXPECT_EQ(valueOf<SFString>(*scene, "STYLUS.touched"), "BLOCK");
}

TEST(TouchSession, AForceLimitHolds) {
  const auto scene = sceneOf(blockAndStylus(kSmooth, 0.02, "forceLimit='0.5'"));
  Playback playback(*scene, {});
  playback.runUntil(2, [&](Time) { EXPECT_LE(valueOf<SFVec3f>(*scene, "STYLUS.force").norm(), 0.5001f); });
  EXPECT_NEAR(valueOf<SFVec3f>(*scene, "STYLUS.force").norm(), 0.5, 1e-3);
}

TEST(TouchSession, OneFieldMapsTheWorkspaceToTheScenesSize) {
  const auto scene = sceneOf(
      "<Transform translation='0 0 -10'><Shape><Appearance><SmoothSurface stiffness='0.5'/></Appearance>"
      "<Box size='20 20 20'/></Shape></Transform>"
      "<DeviceInfo><SimulatedDevice DEF='STYLUS' workspaceScale='100' proxyRadius='0.25' key='0 1' "
      "keyValue='0 0 0.05 0 0 -0.01' handStiffness='5000' handDamping='20'/></DeviceInfo>");
  Playback playback(*scene, {});
  playback.runUntil(2);
  EXPECT_NEAR(valueOf<SFVec3f>(*scene, "STYLUS.proxyPosition").z(), 0.25, 1e-4);
  const float under = 0.25f - valueOf<SFVec3f>(*scene, "STYLUS.trackerPosition").z();  // [m] of the scene
  EXPECT_NEAR(valueOf<SFVec3f>(*scene, "STYLUS.force").z(), 200 * under / 100, 1e-2)
      << "200 N/m of the hand's metres";
}

TEST(TouchSession, ACalibrationTurnsPositionsAndForces) {
  // the device's +x is the scene's +z
  const auto scene = sceneOf(
      "<Transform translation='0 0 -0.1'><Shape><Appearance><SmoothSurface stiffness='0.5'/></Appearance>"
      "<Box size='0.2 0.2 0.2'/></Shape></Transform><DeviceInfo><SimulatedDevice DEF='STYLUS' "
      "positionCalibration='0 0 -1 0  0 1 0 0  1 0 0 0  0 0 0 1' key='0 1' keyValue='0.05 0 0 -0.005 0 "
      "0'/></DeviceInfo>");
  Playback playback(*scene, {});
  playback.runUntil(2);
  EXPECT_GT(valueOf<SFVec3f>(*scene, "STYLUS.force").z(), 0.2f);
  EXPECT_NEAR(valueOf<SFVec3f>(*scene, "STYLUS.trackerPosition").z(),
              valueOf<SFVec3f>(*scene, "STYLUS.devicePosition").x(), 1e-6);
}

TEST(TouchSession, TheWorkspaceStandsBeforeTheViewer) {
  const auto scene = sceneOf(
      "<Viewpoint position='1 0 0' orientation='0 1 0 1.5708' centerOfRotation='0.2 0 0'/>"
      "<DeviceInfo><SimulatedDevice DEF='STYLUS' followViewpoint='true' key='0' keyValue='0 0 "
      "0.1'/></DeviceInfo>");
  Playback playback(*scene, {});
  playback.runUntil(0.5);
  EXPECT_NEAR((valueOf<SFVec3f>(*scene, "STYLUS.trackerPosition") - Vec3f(0.3f, 0, 0)).norm(), 0, 1e-3);
}

TEST(TouchSession, TheTipIsSeenOnWhatIsHardAndInWhatIsSoft) {
  const auto hard = sceneOf(blockAndStylus("<SmoothSurface stiffness='0.2'/>", 0.01));
  Playback(*hard, {}).runUntil(2);
  EXPECT_EQ(valueOf<SFVec3f>(*hard, "STYLUS.tipPosition"), valueOf<SFVec3f>(*hard, "STYLUS.proxyPosition"));
}

TEST(TouchSession, ForceEffectsAct) {
  const auto scene = sceneOf(
      "<DeviceInfo><SimulatedDevice DEF='STYLUS'/></DeviceInfo>"
      "<Transform rotation='0 0 1 1.5708'><ForceField DEF='FIELD' force='1 0 0'/></Transform>"
      "<SpringEffect DEF='SPRING' position='0.005 0 0' springConstant='50' startDistance='0.02'/>"
      "<ViscosityEffect DEF='FLUID' viscosity='1' enabled='false'/>"
      "<TimeFunctionEffect><SineFunction containerField='zFunction' amplitude='0.5' "
      "frequency='2'/></TimeFunctionEffect>");
  Playback playback(*scene, {.step = 0.125});
  playback.runUntil(2.125);  // a quarter of the sine's period
  const Vec3f force = valueOf<SFVec3f>(*scene, "STYLUS.force");
  const Vec3f at = valueOf<SFVec3f>(*scene, "STYLUS.trackerPosition");
  const Vec3f ofSpring = 50 * (Vec3f(0.005f, 0, 0) - at);
  EXPECT_NEAR(force.y() - ofSpring.y(), 1, 1e-3) << "the field, in its group's frame";
  EXPECT_NEAR(force.z() - ofSpring.z(), 0.5, 1e-3) << "the sine at its top";
  EXPECT_TRUE(valueOf<SFBool>(*scene, "SPRING.active"));
  EXPECT_NEAR((valueOf<SFVec3f>(*scene, "SPRING.force") - ofSpring).norm(), 0, 1e-3);
  EXPECT_GT(force.x(), 0.1f);
}

TEST(TouchSession, ASceneThatJumpsFarAheadIsNotWaitedFor) {
  const auto scene = sceneOf(blockAndStylus(kSmooth, 0.005));
  Playback playback(*scene, {.step = 1000});
  playback.runUntil(1e5);
  EXPECT_EQ(valueOf<SFString>(*scene, "STYLUS.touched"), "BLOCK");
  EXPECT_NEAR(valueOf<SFVec3f>(*scene, "STYLUS.force").z(), 0.96, 0.05);
}

TEST(TouchSession, ARecordedSessionGivesTheSameForcesBitForBit) {
  const TemporaryFolder folder;
  const auto forces = [](const TouchOptions& touch) {
    const auto scene = sceneOf(blockAndStylus("<FrictionalSurface stiffness='1' damping='0.1'/>", 0.003));
    Playback playback(*scene, {.touch = touch});
    std::vector<Vec3f> all;
    playback.runUntil(1.5, [&](Time) { all.push_back(valueOf<SFVec3f>(*scene, "STYLUS.force")); });
    return all;
  };
  const auto file = folder.path() / "session.recording";
  const auto first = forces({.record = file});
  EXPECT_EQ(forces({.device = "recorded", .stylus = file}), first);
  EXPECT_GT(first.back().z(), 0.5f);
}

TEST(TouchSession, AMagneticSurfaceDrawsTheTip) {
  const auto scene = sceneOf(
      "<Shape DEF='PLATE'><Appearance><MagneticSurface stiffness='0.5' snapDistance='0.01'/></Appearance>"
      "<Box size='0.1 0.1 0.02'/></Shape>"
      "<DeviceInfo><SimulatedDevice DEF='STYLUS' key='0 1' keyValue='0 0 0.05 0 0 0.0165'/></DeviceInfo>");
  Playback playback(*scene, {});
  playback.runUntil(2);
  EXPECT_EQ(valueOf<SFString>(*scene, "STYLUS.touched"), "PLATE");
  EXPECT_LT(valueOf<SFVec3f>(*scene, "STYLUS.force").z(), -0.1f) << "4 mm above it";
}

}  // namespace
}  // namespace pleura
