#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/standard/grouping/x3d_grouping_node.h>
#include <pleura/tests/x3d/browser/load_scene.h>
#include <pleura/x3d/browser/view/scene_view.h>

namespace pleura {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr auto kBox = "<Shape><Appearance><Material/></Appearance><Box size='1 1 1'/></Shape>";

std::string boxAt(const std::string& place) {
  return "<Transform translation='" + place + "'>" + kBox + "</Transform>";
}

/// A scene and what is seen of it.
struct Seen {
  explicit Seen(const std::string& elements) : scene(sceneOf(elements)), view(*scene) { scene->tick(0); }

  /// Where the items' frames lie on the x axis, in the order they are drawn.
  std::vector<float> places() {
    std::vector<float> x;
    for (const auto& item : view.update().items) x.push_back(item.model(0, 3));
    return x;
  }

  std::unique_ptr<Scene> scene;
  SceneView view;
};

TEST(SceneView, TransformsAddUpOnTheWayDown) {
  Seen seen("<Transform translation='1 0 0' scale='2 2 2'>" + boxAt("3 0 0") + "</Transform>");
  EXPECT_THAT(seen.places(), ElementsAre(1 + 2 * 3));
}

TEST(SceneView, ShowsOnlyWhatIsChosenAndVisible) {
  Seen seen("<Switch DEF='S' whichChoice='1'>" + boxAt("1 0 0") + boxAt("2 0 0") +
            "</Switch><Group DEF='G'>" + boxAt("3 0 0") + "</Group>");
  EXPECT_THAT(seen.places(), ElementsAre(2, 3));
  seen.scene->set("S.whichChoice=-1");
  EXPECT_THAT(seen.places(), ElementsAre(3));
  seen.scene->set("G.visible=false");
  EXPECT_THAT(seen.places(), IsEmpty());
}

TEST(SceneView, AShapeUsedTwiceIsDrawnTwiceFromOneGeometry) {
  Seen seen("<Shape DEF='B'><Box/></Shape><Transform translation='5 0 0'><Shape USE='B'/></Transform>");
  const auto& items = seen.view.update().items;
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(items[0].geometry, items[1].geometry);
  EXPECT_NE(items[0].model(0, 3), items[1].model(0, 3));
}

TEST(SceneView, ANodeTakenAwayIsSeenNoMore) {
  Seen seen("<Group DEF='G'>" + boxAt("1 0 0") + boxAt("2 0 0") + "</Group>");
  auto& children = dynamic_cast<X3DGroupingNode&>(seen.scene->node("G")).children;
  EXPECT_THAT(seen.places(), ElementsAre(1, 2));
  children.erase(children.getValueByIndex(0));
  EXPECT_THAT(seen.places(), ElementsAre(2));
}

TEST(SceneView, OnlyWhatChangedGetsANewRevision) {
  Seen seen(
      "<Shape><IndexedTriangleSet index='0 1 2'><Coordinate DEF='C' point='0 0 0 1 0 0 0 1 0'/>"
      "</IndexedTriangleSet></Shape><Shape><Sphere/></Shape>");
  const auto revisions = [&] {
    std::vector<std::uint64_t> all;
    for (const auto& item : seen.view.update().items) all.push_back(item.geometry->positionsRevision);
    return all;
  };
  const auto before = revisions();
  EXPECT_EQ(revisions(), before);
  seen.scene->set("C.point=0 0 0 1 0 0 0 2 0");
  const auto after = revisions();
  EXPECT_NE(after[0], before[0]);
  EXPECT_EQ(after[1], before[1]);
}

TEST(SceneView, ALightShinesOnItsSiblingsUnlessItIsGlobal) {
  Seen seen(std::string("<Group><DirectionalLight DEF='L'/>") + kBox + "</Group>" + kBox);
  const auto lit = [&] {
    const auto& list = seen.view.update();
    std::vector<bool> all;
    for (const auto& item : list.items) all.push_back((item.lights & 1u) != 0);
    return all;
  };
  EXPECT_THAT(lit(), ElementsAre(true, false));
  seen.scene->set("L.global=true");
  EXPECT_THAT(lit(), ElementsAre(true, true));
  seen.scene->set("L.on=false");
  EXPECT_THAT(seen.view.update().lights, IsEmpty());
}

TEST(SceneView, LooksFromTheBoundViewpointOrTheOneAskedFor) {
  Seen seen(
      "<Transform translation='0 1 0'><Viewpoint DEF='V1' position='0 0 5'/></Transform>"
      "<Viewpoint DEF='V2' position='0 0 7'/><Group DEF='G'/>");
  const auto eye = [&] { return viewerIn(seen.view.update().camera.view); };
  EXPECT_EQ(eye(), Vec3f(0, 1, 5));
  seen.view.lookFrom("V2");
  EXPECT_EQ(eye(), Vec3f(0, 0, 7));
  const auto refusal = [&](const char* name) -> std::string {
    try {
      seen.view.lookFrom(name);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("G"), "the scene has no viewpoint G");
  EXPECT_EQ(refusal("V3"), "the scene has no viewpoint V3; did you mean V1?");
  EXPECT_EQ(eye(), Vec3f(0, 0, 7));
}

TEST(SceneView, WithoutAViewpointAllIsInSight) {
  Seen seen(boxAt("-30 0 0") + boxAt("30 0 0"));
  const auto& list = seen.view.update();
  for (const auto& item : list.items) {
    const Vec4f p = list.camera.view * item.model.col(3);
    EXPECT_LT(std::abs(p.x()), -p.z() * std::tan(list.camera.fieldOfView / 2));
    EXPECT_GT(-p.z(), list.camera.nearDistance);
    EXPECT_LT(-p.z(), list.camera.farDistance);
  }
}

TEST(SceneView, TheFirstPictureAlreadyTurnsBillboardsToTheViewer) {
  Seen seen(std::string("<Viewpoint position='10 0 0' orientation='0 1 0 1.5707963'/><Billboard>") + kBox +
            "</Billboard>");
  const Matrix4f model = seen.view.update().items.at(0).model;
  EXPECT_TRUE(model.col(2).head<3>().isApprox(Vec3f::UnitX(), 1e-5f)) << "its front faces the viewer";
}

TEST(SceneView, TheLevelOfDetailGoesByTheDistance) {
  Seen seen("<Viewpoint DEF='V' position='0 0 1'/><Transform scale='2 2 2'><LOD DEF='L' range='1 3'>" +
            boxAt("1 0 0") + boxAt("2 0 0") + boxAt("3 0 0") + "</LOD></Transform>");
  const auto from = [&](const std::string& distance) {
    seen.scene->set("V.position=0 0 " + distance);
    return seen.places();
  };
  EXPECT_THAT(from("1.9"), ElementsAre(2)) << "half a metre of the group's own";
  EXPECT_THAT(from("2"), ElementsAre(4)) << "a limit belongs to the farther level";
  EXPECT_THAT(from("5.9"), ElementsAre(4));
  EXPECT_THAT(from("100"), ElementsAre(6));
  EXPECT_EQ(valueOf<SFInt32>(*seen.scene, "L.level_changed"), 2);
  seen.scene->set("V.position=0 0 1");
  EXPECT_THAT(seen.places(), ElementsAre(2)) << "and back";
}

TEST(SceneView, ALevelThatIsNotThereIsTheLastOne) {
  Seen seen("<Viewpoint position='0 0 50'/><LOD range='1 2 3'>" + boxAt("1 0 0") + boxAt("2 0 0") +
            "</LOD><LOD range='1'/>");
  EXPECT_THAT(seen.places(), ElementsAre(2));
}

TEST(SceneView, AFlatFrameIsSeenWithoutNumbersThatAreNone) {
  Seen seen(std::string("<Transform scale='0 1 1'><LOD range='1'>") + kBox + "</LOD><Billboard>" + kBox +
            "</Billboard></Transform>");
  for (const auto& item : seen.view.update().items) EXPECT_TRUE(item.model.allFinite());
}

}  // namespace
}  // namespace pleura
