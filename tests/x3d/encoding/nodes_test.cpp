#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/standard/grouping/transform.h>
#include <pleura/nodes/standard/shape/shape.h>
#include <pleura/tests/x3d/encoding/read_scene.h>

namespace pleura {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ReadNodes, DefAndUseAreOneNode) {
  auto scene = ReadScene::ofElements("<Group><Transform DEF='T'/></Group><Transform USE='T'/>");
  EXPECT_THAT(scene.said(), IsEmpty());
  ASSERT_EQ(scene.document.nodes.size(), 2u);
  EXPECT_EQ(scene.document.nodes[1], scene.document.names.at("T"));
  auto& group = dynamic_cast<MFNode&>(*scene.document.nodes[0]->getField("children"));
  EXPECT_EQ(group.getValue().at(0), scene.document.nodes[1]);
}

TEST(ReadNodes, DefGivenTwiceKeepsTheFirst) {
  auto scene = ReadScene::ofElements("<Group DEF='G'/><Transform DEF='G'/>");
  EXPECT_THAT(scene.said(),
              ElementsAre("s.x3d:1:40: warning: DEF G is given twice: the later node keeps no name"));
  EXPECT_EQ(scene.document.names.at("G"), scene.document.nodes[0]);
}

TEST(ReadNodes, UseOfNothingNamesTheNearest) {
  auto scene = ReadScene::ofElements("<Group DEF='LUNG_L'/>\n<Group USE='LUNG_X'/>");
  EXPECT_THAT(scene.said(), ElementsAre("s.x3d:2:13: error: USE LUNG_X: no node of that name stands before; "
                                        "did you mean LUNG_L?"));
}

TEST(ReadNodes, UseOfAnAncestorIsRefused) {
  auto scene = ReadScene::ofElements("<Group DEF='A'><Group><Group USE='A'/></Group></Group>");
  EXPECT_THAT(scene.said(), ElementsAre("s.x3d:1:42: error: USE A: a node can't contain itself"));
}

TEST(ReadNodes, DefaultContainerFieldIsTheTypes) {
  auto scene = ReadScene::ofElements("<Shape DEF='S'><Box DEF='B'/></Shape>");
  EXPECT_THAT(scene.said(), IsEmpty());
  EXPECT_EQ(dynamic_cast<SFNode&>(scene.field("S", "geometry")).getValue(), scene.document.names.at("B"));
}

TEST(ReadNodes, ContainerFieldMovesANode) {
  auto scene = ReadScene::ofElements(
      "<Group DEF='G'><MetadataString DEF='M' containerField='metadata'/></Group>"
      "<MetadataSet DEF='S'><MetadataString USE='M' containerField='value'/></MetadataSet>");
  EXPECT_THAT(scene.said(), IsEmpty());
  EXPECT_EQ(dynamic_cast<SFNode&>(scene.field("G", "metadata")).getValue(), scene.document.names.at("M"));
  EXPECT_EQ(dynamic_cast<MFNode&>(scene.field("S", "value")).getValue().at(0), scene.document.names.at("M"));
}

TEST(ReadNodes, ContainerFieldThatIsNoneOrOfAnotherTypeIsAnError) {
  auto scene =
      ReadScene::ofElements("<Shape><Box containerField='foo'/>\n<Group containerField='geometry'/></Shape>");
  EXPECT_THAT(scene.said(),
              ElementsAre("s.x3d:1:15: error: Shape has no field foo for a node: Box is left out",
                          "s.x3d:2:1: error: Shape.geometry takes no Group: left out"));
}

TEST(ReadNodes, UnknownNodeIsToldOnceWithTheNearestNameAndTheRestGoesOn) {
  auto scene = ReadScene::ofElements("\n <Transfrom><Box/></Transfrom><Transfrom/><Group/>");
  EXPECT_THAT(scene.said(), ElementsAre("s.x3d:2:2: warning: unknown node Transfrom: left out with what it "
                                        "contains; did you mean Transform?"));
  EXPECT_EQ(scene.document.nodes.size(), 1u);
}

TEST(ReadNodes, UnknownFieldIsAWarningWithTheNearestName) {
  auto scene = ReadScene::ofElements("\n<Transform DEF='T'\n  translaton='1 2 3' scale='2 2 2'/>");
  EXPECT_THAT(scene.said(),
              ElementsAre("s.x3d:3:15: warning: T has no field translaton; did you mean translation?"));
  EXPECT_EQ(scene.value("T", "scale"), "2 2 2");
}

TEST(ReadNodes, BareGroupIsARoot) {
  auto scene = ReadScene::ofText("<Group DEF='G'><Shape/></Group>");
  EXPECT_THAT(scene.said(), IsEmpty());
  EXPECT_EQ(scene.document.nodes.size(), 1u);
}

TEST(ReadNodes, NodesAreInitialized) {
  auto scene = ReadScene::ofElements("<Shape DEF='S'><Box DEF='B'/></Shape>");
  EXPECT_TRUE(scene.document.names.at("S")->isInitialized());
  EXPECT_TRUE(scene.document.names.at("B")->isInitialized());
}

}  // namespace
}  // namespace pleura
