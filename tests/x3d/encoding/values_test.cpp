#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/tests/x3d/encoding/read_scene.h>

namespace pleura {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ReadValues, CommasAreWhiteSpace) {
  auto scene = ReadScene::ofElements("<Transform DEF='T' translation=' 1,2,,\t3, '/>");
  EXPECT_THAT(scene.said(), IsEmpty());
  EXPECT_EQ(scene.value("T", "translation"), "1 2 3");
}

TEST(ReadValues, AListOfStringsWithoutQuotesIsOneString) {
  auto scene = ReadScene::ofElements(
      "<Anchor DEF='A' url='./left rib.x3d'/>\n<Anchor DEF='B' url='./b.x3d'/><Anchor DEF='C' url=' '/>");
  EXPECT_THAT(scene.said(),
              ElementsAre("s.x3d:1:29: warning: A.url: read as one string; strings of a list stand in "
                          "double quotes"));
  EXPECT_EQ(scene.value("A", "url"), "\"./left rib.x3d\"");
  EXPECT_EQ(scene.value("B", "url"), "\"./b.x3d\"");
  EXPECT_EQ(scene.value("C", "url"), "");
}

TEST(ReadValues, BadTokenIsToldWithItsPlaceAndTheDefaultStays) {
  auto scene = ReadScene::ofElements("\n\n  <Transform DEF='T' scale='2 x2 2'/>");
  EXPECT_THAT(scene.said(),
              ElementsAre("s.x3d:3:31: error: T.scale: expected a finite number (SFVec3f), found \"x2\""));
  EXPECT_EQ(scene.value("T", "scale"), "1 1 1");
}

TEST(ReadValues, TooFewAndTooManyNumbersAreToldByTheirCount) {
  auto scene = ReadScene::ofElements(
      "<Transform translation='1 2'/>\n<Transform scale='1 2 3 4'/>\n<Coordinate point='1 2 3 4'/>\n"
      "<Sphere radius=''/>");
  EXPECT_THAT(
      scene.said(),
      ElementsAre("s.x3d:1:35: error: Transform.translation: expected 3 numbers (SFVec3f), found 2",
                  "s.x3d:2:25: error: Transform.scale: expected nothing more after 3 numbers "
                  "(SFVec3f), found \"4\"",
                  "s.x3d:3:27: error: Coordinate.point: expected a multiple of 3 numbers (MFVec3f), "
                  "found 4",
                  "s.x3d:4:17: error: Sphere.radius: expected a finite number (SFFloat), found nothing"));
}

TEST(ReadValues, BadTokenOnALaterLineOfTheValue) {
  auto scene = ReadScene::ofElements("<Coordinate DEF='C' point='0 0 0\n 1 1 1\n 2 oh 2'/>");
  ASSERT_EQ(scene.diagnostics.all().size(), 1u);
  EXPECT_EQ(scene.diagnostics.all()[0].place.line, 3);
  EXPECT_EQ(scene.diagnostics.all()[0].place.column, 4);
  EXPECT_EQ(scene.value("C", "point"), "");
}

TEST(ReadValues, EveryKindOfBadValueKeepsTheDefault) {
  const struct {
    const char* node;
    const char* field;
    const char* text;
    const char* byDefault;
  } kCases[] = {
      {"Transform", "translation", "1 2", "0 0 0"},
      {"Transform", "translation", "1 2 3 4", "0 0 0"},
      {"Transform", "translation", "nan 0 0", "0 0 0"},
      {"Transform", "translation", "0 inf 0", "0 0 0"},
      {"Transform", "translation", "1e999 0 0", "0 0 0"},
      {"Transform", "rotation", "0 0 1", "0 0 1 0"},
      {"Transform", "visible", "yes", "true"},
      {"Sphere", "radius", "-1", "1"},
      {"Sphere", "radius", "0", "1"},
      {"Sphere", "radius", "", "1"},
      {"TimeSensor", "cycleInterval", "-2", "1"},
      {"IndexedTriangleSet", "index", "0 1 2.5", ""},
      {"IndexedTriangleSet", "index", "99999999999", ""},
      {"WorldInfo", "info", "\"open", ""},
  };
  for (const auto& each : kCases) {
    SCOPED_TRACE(std::string(each.node) + "." + each.field + "='" + each.text + "'");
    auto scene = ReadScene::ofElements(std::string("<") + each.node + " DEF='N' " + each.field + "='" +
                                       each.text + "'/>");
    EXPECT_EQ(scene.diagnostics.errors(), 1u);
    ASSERT_EQ(scene.said().size(), 1u);
    EXPECT_THAT(scene.said()[0], HasSubstr(std::string("N.") + each.field));
    EXPECT_EQ(scene.value("N", each.field), each.byDefault);
  }
}

TEST(ReadValues, XmlsOwnEntitiesAreTheirCharacters) {
  auto scene = ReadScene::ofElements("<WorldInfo DEF='W' title='a &amp; b &#38; &lt;c&gt; &apos;&quot;'/>");
  EXPECT_EQ(scene.value("W", "title"), "a & b & <c> '\"");
}

TEST(ReadValues, OutputOnlyTakesNoValue) {
  auto scene = ReadScene::ofElements("<TimeSensor DEF='C' time='3'/>");
  EXPECT_THAT(scene.said(),
              ElementsAre("s.x3d:1:34: error: C.time is outputOnly: a file can't give it a value"));
}

TEST(ReadValues, AllFaultsInOneRun) {
  auto scene = ReadScene::ofElements(
      "\n<Transform DEF='T' scale='a'/>\n<Spher/>\n<Group USE='NOBODY'/>\n<Sphere radius='-1'/>\n"
      "<ROUTE fromNode='T' fromField='scale' toNode='T' toField='rotation'/>\n<Group colour='red'/>");
  EXPECT_EQ(scene.diagnostics.errors(), 4u);
  EXPECT_EQ(scene.diagnostics.warnings(), 2u);
  std::vector<int> lines;
  for (const auto& each : scene.diagnostics.all()) lines.push_back(each.place.line);
  EXPECT_THAT(lines, ElementsAre(2, 3, 4, 5, 7, 6))
      << "routes are made at the end, so that they may look ahead";
}

TEST(ReadValues, AFaultRepeatedWithoutEndIsCountedAndNotListed) {
  std::string many;
  for (int i = 0; i < 5000; ++i) many += "<Sphere radius='x'/>\n";
  auto scene = ReadScene::ofElements(many);
  EXPECT_EQ(scene.diagnostics.errors(), 5000u);
  EXPECT_LE(scene.diagnostics.all().size(), 1000u);
  EXPECT_EQ(scene.diagnostics.unlisted() + scene.diagnostics.all().size(), 5000u);
}

TEST(ReadUnits, LengthsAndAnglesBecomeSi) {
  auto scene = ReadScene::ofText(
      "<X3D><head><unit category='length' name='mm' conversionFactor='0.001'/>"
      "<unit category='angle' name='degree' conversionFactor='0.5'/></head><Scene>"
      "<Transform DEF='T' translation='1000 0 500' scale='2 2 2' rotation='0 1 0 2'/></Scene></X3D>");
  EXPECT_THAT(scene.said(), IsEmpty());
  EXPECT_EQ(scene.value("T", "translation"), "1 0 0.5");
  EXPECT_EQ(scene.value("T", "scale"), "2 2 2") << "a factor has no unit";
  EXPECT_EQ(scene.value("T", "rotation"), "0 1 0 1") << "the axis stays";
}

TEST(ReadUnits, BadUnitsAreErrors) {
  auto scene = ReadScene::ofElements(
      "<unit category='speed' conversionFactor='1'/>\n<unit category='length' conversionFactor='0'/>\n"
      "<unit category='length' conversionFactor='nan'/>\n<unit category='mass' conversionFactor='-1'/>");
  EXPECT_EQ(scene.diagnostics.errors(), 4u);
  EXPECT_THAT(scene.said()[0], HasSubstr("s.x3d:1:8: error: unit: category is angle, force, length or mass"));
  EXPECT_EQ(scene.said()[1], "s.x3d:2:43: error: unit: conversionFactor is a number above 0");
  EXPECT_THAT(scene.document.units, IsEmpty());
}

TEST(ReadLibrary, MissingLibraryIsAnErrorThatNamesIt) {
  auto scene = ReadScene::ofElements("\n <ImportLibrary library='\"nosuch\"'/><Group/>");
  ASSERT_EQ(scene.said().size(), 1u);
  EXPECT_THAT(scene.said()[0], HasSubstr("s.x3d:2:2: error: ImportLibrary: library nosuch not found"));
  EXPECT_EQ(scene.document.nodes.size(), 1u);
}

TEST(ReadLibrary, APathIsNoNameOfALibrary) {
  auto scene = ReadScene::ofElements("<ImportLibrary library='\"../evil\"'/>");
  EXPECT_EQ(scene.diagnostics.errors(), 1u);
}

}  // namespace
}  // namespace pleura
