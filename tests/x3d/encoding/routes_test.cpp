#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/tests/x3d/encoding/read_scene.h>

namespace pleura {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// What the reader says of one route between two transforms and a clock.
std::vector<std::string> saidOf(const std::string& fromNode, const std::string& fromField,
                                const std::string& toNode, const std::string& toField) {
  return ReadScene::ofElements(
             "<Transform DEF='LEFT'/><Transform DEF='RIGHT'/><TimeSensor DEF='CLOCK'/>\n<ROUTE fromNode='" +
             fromNode + "' fromField='" + fromField + "' toNode='" + toNode + "' toField='" + toField + "'/>")
      .said();
}

TEST(ReadRoutes, ARouteCarriesItsValue) {
  auto scene = ReadScene::ofElements(
      "<Transform DEF='A' translation='1 2 3'/><Transform DEF='B'/>"
      "<ROUTE fromNode='A' fromField='translation' toNode='B' toField='translation'/>");
  EXPECT_THAT(scene.said(), IsEmpty());
  EXPECT_EQ(scene.value("B", "translation"), "1 2 3");
  scene.field("A", "translation").setValueFromString("4 5 6");
  EXPECT_EQ(scene.value("B", "translation"), "4 5 6");
}

TEST(ReadRoutes, ARouteMayStandBeforeItsNodes) {
  auto scene = ReadScene::ofElements(
      "<ROUTE fromNode='A' fromField='translation' toNode='B' toField='translation'/>"
      "<Transform DEF='A' translation='1 2 3'/><Transform DEF='B'/>");
  EXPECT_THAT(scene.said(), IsEmpty());
  EXPECT_EQ(scene.value("B", "translation"), "1 2 3");
}

TEST(ReadRoutes, SetAndChangedNamesAreUnderstood) {
  EXPECT_THAT(saidOf("LEFT", "translation_changed", "RIGHT", "set_translation"), IsEmpty());
}

TEST(ReadRoutes, TypesMustFit) {
  EXPECT_THAT(saidOf("LEFT", "translation", "RIGHT", "rotation"),
              ElementsAre("s.x3d:2:1: error: route LEFT.translation TO RIGHT.rotation: SFVec3f sent where "
                          "SFRotation is expected"));
}

TEST(ReadRoutes, AnOutputTakesNoEvents) {
  EXPECT_THAT(
      saidOf("LEFT", "visible", "CLOCK", "isActive"),
      ElementsAre("s.x3d:2:1: error: route LEFT.visible TO CLOCK.isActive: CLOCK.isActive is outputOnly, it "
                  "takes no events"));
}

TEST(ReadRoutes, UnknownEndsNameTheNearest) {
  EXPECT_THAT(saidOf("LEFT", "translaton", "RIGHT", "translation"),
              ElementsAre("s.x3d:2:1: error: ROUTE: LEFT (Transform) has no field translaton; did you mean "
                          "translation?"));
  EXPECT_THAT(saidOf("LEFT", "translation", "RIGHTT", "translation"),
              ElementsAre("s.x3d:2:1: error: ROUTE: no node RIGHTT; did you mean RIGHT?"));
}

TEST(ReadRoutes, BothBadEndsAreTold) { EXPECT_EQ(saidOf("A", "b", "C", "d").size(), 2u); }

TEST(ReadRoutes, ACycleEnds) {
  auto scene = ReadScene::ofElements(
      "<Transform DEF='A'/><Transform DEF='B'/>"
      "<ROUTE fromNode='A' fromField='translation' toNode='B' toField='translation'/>"
      "<ROUTE fromNode='B' fromField='translation' toNode='A' toField='translation'/>");
  EXPECT_THAT(scene.said(), IsEmpty());
  scene.field("A", "translation").setValueFromString("4 5 6");
  EXPECT_EQ(scene.value("B", "translation"), "4 5 6");
}

}  // namespace
}  // namespace pleura
