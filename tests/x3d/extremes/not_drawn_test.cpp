#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/tests/x3d/browser/load_scene.h>
#include <pleura/x3d/browser/view/scene_view.h>

namespace pleura {
namespace {

using testing::HasSubstr;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// What a scene says once it has been seen, and how many things were drawn.
struct Seen {
  std::string said;
  std::size_t drawn = 0;
};

Seen see(Scene& scene) {
  Seen seen;
  seen.drawn = SceneView(scene).update().items.size();
  for (const auto& each : scene.diagnostics().all()) seen.said += toText(each) + "\n";
  return seen;
}

/// Two boxes, the first in a Transform T with the Material M.
std::unique_ptr<Scene> twoBoxes(const std::string& more = {}) {
  return sceneOf(
      "<Transform DEF='T'><Shape DEF='S'><Appearance><Material "
      "DEF='M'/></Appearance><Box/></Shape></Transform>"
      "<Shape><Box/></Shape>" +
      more);
}

TEST(NotDrawn, AShapeThatStandsNowhere) {
  const auto scene = twoBoxes();
  EXPECT_EQ(see(*scene).drawn, 2u);
  dynamic_cast<SFVec3f&>(scene->field("T.translation")).setValue({kNaN, 0, 0});
  const Seen seen = see(*scene);
  EXPECT_EQ(seen.drawn, 1u);
  EXPECT_THAT(seen.said, HasSubstr("warning: S: item.model is not finite: not drawn"));
}

TEST(NotDrawn, AMaterialBeyondItsRange) {
  const auto scene = twoBoxes();
  dynamic_cast<SFFloat&>(scene->field("M.transparency")).setValue(2);
  const Seen seen = see(*scene);
  EXPECT_EQ(seen.drawn, 1u);
  EXPECT_THAT(seen.said, HasSubstr("warning: S: material.transparency is 2, outside [0, 1]: not drawn"));
}

TEST(NotDrawn, AMeshWithAPointThatIsNone) {
  const auto scene = twoBoxes(
      "<Shape><IndexedTriangleSet DEF='MESH' index='0 1 2'>"
      "<Coordinate DEF='C' point='0 0 0 1 0 0 0 1 0'/></IndexedTriangleSet></Shape>");
  EXPECT_EQ(see(*scene).drawn, 3u);
  dynamic_cast<MFVec3f&>(scene->field("C.point")).setValue({{0, 0, 0}, {1, 0, 0}, {0, kNaN, 0}});
  const Seen seen = see(*scene);
  EXPECT_EQ(seen.drawn, 2u);
  EXPECT_THAT(seen.said, HasSubstr("MESH: geometry.positions holds a value that is not finite: not drawn"));
}

TEST(NotDrawn, ABackgroundWithTooFewAngles) {
  EXPECT_THAT(see(*twoBoxes("<Background DEF='SKY' skyColor='1 0 0 0 1 0'/>")).said,
              HasSubstr("SKY: background.skyColor needs one value more than skyAngle: not drawn"));
}

TEST(NotDrawn, NothingThroughAViewpointThatIsNowhere) {
  const auto scene = twoBoxes("<Viewpoint DEF='V'/>");
  dynamic_cast<SFVec3f&>(scene->field("V.position")).setValue({0, kNaN, 0});
  const Seen seen = see(*scene);
  EXPECT_THAT(seen.said, HasSubstr("V: camera.view is not finite: not drawn"));
  EXPECT_EQ(seen.drawn, 2u) << "seen from elsewhere";
}

}  // namespace
}  // namespace pleura
