#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/tests/x3d/encoding/read_scene.h>
#include <pleura/x3d/encoding/writer.h>

namespace pleura {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// write -> read -> write gives the same bytes.
void expectRoundTrip(Document& document) {
  const std::string first = writeX3d(document);
  auto again = ReadScene::ofText(first);
  EXPECT_THAT(again.said(), IsEmpty()) << first;
  EXPECT_EQ(writeX3d(again.document), first);
}

TEST(Writer, EveryStandardTypeAtItsDefaults) {
  ReadScene scene;
  for (const NodeType* type : scene.registry.types()) {
    if (type->name() == "Inline") continue;  // has nothing to load
    SCOPED_TRACE(type->name());
    Document document;
    document.nodes = {type->create()};
    EXPECT_THAT(writeX3d(document), HasSubstr("    <" + type->name() + "/>\n")) << "defaults are left out";
    expectRoundTrip(document);
  }
}

TEST(Writer, EveryFieldOfEveryStandardTypeReadsBackTheSame) {
  constexpr const char* kTexts[] = {
      "0.7071068 0.1234567 0.3333333 0.1",       "0.25 0.5 0.125", "0.1 0.3", "0.3", "3", "true", "false",
      "\"tab\there\" \"it's <\\\"& quoted\\\"\""};
  ReadScene scene;
  for (const NodeType* type : scene.registry.types()) {
    if (type->name() == "Inline") continue;  // has nothing to load
    SCOPED_TRACE(type->name());
    const NodePtr node = type->create();
    for (const auto& declared : type->fields()) {
      const bool isState =
          declared->access == Access::inputOutput || declared->access == Access::initializeOnly;
      if (!isState || singleOf(declared->type) == FieldType::SFNode || declared->name == "url") continue;
      for (const char* text : kTexts) try {
          declared->of(*node).setValueFromString(text);
          break;
        } catch (const FieldError&) {
        }
    }
    Document document;
    document.nodes = {node};
    expectRoundTrip(document);
  }
}

TEST(Writer, UseAndRoutesAndHead) {
  auto scene = ReadScene::ofText(
      "<X3D profile='Full' version='4.0'><head><component name='Text' level='1'/><meta name='title' "
      "content='it&apos;s &lt;'/>"
      "</head><Scene><Group DEF='A'><Shape DEF='S'><Appearance><Material DEF='M' diffuseColor='1 0 "
      "0'/></Appearance>"
      "<Box/></Shape></Group><Transform DEF='T'><Shape USE='S'/></Transform><EXPORT localDEF='T' AS='OUT'/>"
      "<ROUTE fromNode='T' fromField='translation' toNode='T' toField='center'/></Scene></X3D>");
  ASSERT_THAT(scene.said(), IsEmpty());
  const std::string text = writeX3d(scene.document);
  EXPECT_THAT(text, HasSubstr("USE='S'"));
  EXPECT_THAT(text, HasSubstr("<ROUTE fromNode='T' fromField='translation' toNode='T' toField='center'/>"));
  EXPECT_THAT(text, HasSubstr("<EXPORT localDEF='T' AS='OUT'/>"));
  expectRoundTrip(scene.document);
}

TEST(Writer, ANamelessNodeThatStandsTwiceGetsAFreeName) {
  ReadScene scene;
  const NodePtr shared = scene.registry.find("Group")->create();
  const NodePtr taken = scene.registry.find("Transform")->create();
  taken->setName("Group_1");
  Document document;
  document.nodes = {taken, shared, shared};
  const std::string text = writeX3d(document);
  EXPECT_THAT(text, HasSubstr("<Group DEF='Group_2'/>\n    <Group USE='Group_2'/>"));
  expectRoundTrip(document);
}

TEST(Writer, FileUnitsBecomeSi) {
  auto scene = ReadScene::ofElements(
      "<unit category='length' conversionFactor='0.001'/><Transform translation='1000 0 0'/>");
  const std::string text = writeX3d(scene.document);
  EXPECT_THAT(text, HasSubstr("translation='1 0 0'"));
  EXPECT_THAT(text, Not(HasSubstr("<unit")));
  expectRoundTrip(scene.document);
}

TEST(Writer, AnInlineStaysAnInline) {
  auto scene = ReadScene::ofElements("<Inline DEF='I' load='false' url='\"a.x3d\"'/>");
  EXPECT_THAT(writeX3d(scene.document), HasSubstr("<Inline DEF='I' load='false' url='\"a.x3d\"'/>"));
  expectRoundTrip(scene.document);
}

TEST(Writer, NumbersReadBackToTheSameBits) {
  auto scene = ReadScene::ofElements("<Coordinate DEF='C'/>");
  auto& point = dynamic_cast<MFVec3f&>(scene.field("C", "point"));
  const std::vector<Vec3f> exact = {
      {0.1f, 1e-38f, 3.4028235e38f}, {-0.f, 16777217.f, 1.f / 3}, {1e-45f, -2.5e-7f, 123456.79f}};
  point.setValue(exact);
  auto again = ReadScene::ofText(writeX3d(scene.document));
  EXPECT_EQ(dynamic_cast<MFVec3f&>(again.field("C", "point")).getValue(), exact);
}

}  // namespace
}  // namespace pleura
