#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/fields/errors.h>
#include <pleura/nodes/standard/grouping/group.h>
#include <pleura/tests/x3d/browser/load_scene.h>
#include <pleura/x3d/browser/scene/state_hash.h>

namespace pleura {
namespace {

using testing::HasSubstr;

/// What the message is when a name is not known.
template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const UnknownNameError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Scene, TimeReachesTheNodes) {
  const auto scene = sceneOf("<TimeSensor DEF='CLOCK' loop='true' cycleInterval='4'/>");
  for (const double now : {0.0, 1.0, 2.0, 3.0}) {
    scene->tick(now);
    EXPECT_FLOAT_EQ(valueOf<SFFloat>(*scene, "CLOCK.fraction_changed"), static_cast<float>(now / 4));
  }
}

TEST(Scene, KeysReachTheSensor) {
  const auto scene = sceneOf("<KeySensor DEF='KEYS'/>");
  scene->tick(0);
  KeyEvent event{.character = "q"};
  scene->key(event);
  EXPECT_TRUE(valueOf<SFBool>(*scene, "KEYS.isActive"));
  EXPECT_EQ(valueOf<SFString>(*scene, "KEYS.keyPress"), "q");
  event.pressed = false;
  scene->key(event);
  EXPECT_FALSE(valueOf<SFBool>(*scene, "KEYS.isActive"));
}

TEST(Scene, SetTakesTheFieldsText) {
  const auto scene = sceneOf("<Transform DEF='T'/>");
  scene->set("T.translation=1 2 3");
  EXPECT_EQ(valueOf<SFVec3f>(*scene, "T.translation"), Vec3f(1, 2, 3));
}

TEST(Scene, SetRefusesWhatDoesNotFitAndChangesNothing) {
  const auto scene = sceneOf("<Transform DEF='T' translation='1 2 3'/><TimeSensor DEF='C'/>");
  for (const char* bad :
       {"T.translation=1 2", "T.translation=nan 0 0", "T.translation=", "C.time=3", "C.cycleInterval=-1"})
    EXPECT_THROW(scene->set(bad), FieldError) << bad;
  EXPECT_EQ(valueOf<SFVec3f>(*scene, "T.translation"), Vec3f(1, 2, 3));
}

TEST(Scene, WhatANodeComplainsOfIsToldWithItsPlaceAndOnce) {
  const TemporaryFolder folder;
  folder.write("part.x3d", "<Scene>\n  <Group DEF='PART'/>\n<EXPORT localDEF='PART'/></Scene>");
  Scene scene;
  scene.load(folder.write("s.x3d",
                          "<Scene>\n<Group/>\n <Group/>\n<Inline DEF='I' url='\"part.x3d\"'/>"
                          "<IMPORT inlineDEF='I' importedDEF='PART'/></Scene>"));
  for (int time = 0; time < 2; ++time)
    for (const auto& node : {scene.document().nodes[0], scene.document().nodes[1]})
      scene.warn(*node, "is odd");
  scene.warn(scene.node("PART"), "is odd");
  scene.warn(*create<Group>(), "was not read");
  std::vector<std::string> told;
  for (const auto& each : scene.diagnostics().all())
    told.push_back(std::filesystem::path(toText(each)).filename().string());
  EXPECT_THAT(told, testing::ElementsAre(
                        "s.x3d:2:1: warning: Group: is odd", "s.x3d:3:2: warning: Group: is odd",
                        "part.x3d:2:3: warning: PART: is odd", "s.x3d: warning: Group: was not read"));
}

TEST(Scene, UnknownNamesAreToldWithTheNearest) {
  const auto scene = sceneOf("<Transform DEF='LUNG_L'/>");
  EXPECT_THAT(refusal([&] { scene->node("LUNG_K"); }), HasSubstr("did you mean LUNG_L?"));
  EXPECT_THAT(refusal([&] { scene->field("LUNG_K.translation"); }), HasSubstr("did you mean LUNG_L?"));
  EXPECT_THAT(refusal([&] { scene->field("LUNG_L.translaton"); }), HasSubstr("did you mean translation?"));
  EXPECT_THAT(refusal([&] { scene->field("LUNG_L"); }), HasSubstr("expected DEF.field"));
  EXPECT_THAT(refusal([&] { scene->set("LUNG_L.translation"); }), HasSubstr("expected DEF.field=VALUE"));
}

TEST(Scene, AWarningOfEveryTickIsToldOnce) {
  const auto scene = sceneOf("<Transform DEF='T'/>");
  for (int i = 0; i < 10; ++i) scene->warn(scene->node("T"), "is odd");
  EXPECT_EQ(scene->diagnostics().warnings(), 1u);
}

TEST(StateHash, EqualOverTwoRunsAndOtherForOtherStates) {
  const auto run = [](const char* set) {
    const auto scene = sceneOfABreath();
    scene->set(set);
    for (int k = 0; k < 40; ++k) scene->tick(k * 0.1);
    return stateHash(*scene);
  };
  EXPECT_EQ(run("BREATH.rate=12"), run("BREATH.rate=12"));
  EXPECT_NE(run("BREATH.rate=12"), run("BREATH.rate=13"));
}

TEST(StateHash, LookingChangesNothing) {
  const auto scene = sceneOfABreath();
  for (int k = 0; k < 40; ++k) scene->tick(k * 0.1);
  const auto first = stateHash(*scene);
  EXPECT_EQ(stateHash(*scene), first);
}

}  // namespace
}  // namespace pleura
