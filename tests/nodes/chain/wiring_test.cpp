#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/solve_counter.h>
#include <pleura/tests/nodes/chain/chain_scene.h>

namespace pleura {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string route(const std::string& from, const std::string& fromField, const std::string& to,
                  const std::string& toField) {
  return "<ROUTE fromNode='" + from + "' fromField='" + fromField + "' toNode='" + to + "' toField='" +
         toField + "'/>";
}

/// A triangle for a rib with its Coordinate; turns by a quarter about the z axis at full inflation.
std::string rib(const std::string& name, const std::string& points) {
  return "<RotTransform DEF='" + name + "' angles='0 1.5707964 1'><Shape><IndexedTriangleSet index='0 1 2'>" +
         "<Coordinate DEF='" + name + " COORD' point='" + points +
         "'/></IndexedTriangleSet></Shape></RotTransform>";
}

/// A contact node between a rib and SHEET, and its routes.
std::string contact(const std::string& name, const std::string& ribName, const std::string& dist) {
  return "<RotTransform DEF='" + name + "' dist='" + dist + "'/>" +
         route(ribName + " COORD", "point", name, "coord1") + route("SHEET COORD", "point", name, "coord2") +
         route(name, "touch", ribName, "touch") + route(name, "touch", "SHEET", "touch_point_to_update") +
         route(name, "rigid_touch", "SHEET", "touch_rigid_points") +
         route(ribName, "rib_points", "SHEET", "points_to_follow");
}

const std::string kSheet =
    "<DeformableShape2 DEF='SHEET'><ChainmailDeformer stretchFactor='1000' shearFactor='1000'/>"
    "<IndexedTriangleSet index='0 1 2 1 3 2'><Coordinate DEF='SHEET COORD' point='0 0 0  1 0 0  0 0 1  1 0 "
    "1'/></IndexedTriangleSet></DeformableShape2>";
/// Its second point is at (1, 0.1, 0), over the sheet's second.
const std::string kNearRib = rib("NEAR", "5 5 5  1 0.1 0  5 5 6");
const std::string kAll = ", 0, -100, 100, -100";

void inflate(Scene& scene) {
  for (const auto* each : {"NEAR.inflation=1", "FAR.inflation=1"}) try {
      scene.set(each);
    } catch (const UnknownNameError&) {
      continue;
    }
}

Vec3f sheetPoint(Scene& scene, std::size_t i) { return valueOf<MFVec3f>(scene, "SHEET.deformedCoord").at(i); }

TEST(ChainWiring, ContactsArePairsOfNearPoints) {
  const auto scene = chainSceneOf(kNearRib + kSheet + contact("TOUCH", "NEAR", "0.2" + kAll));
  EXPECT_EQ(toldBy(*scene), "");
  EXPECT_THAT(valueOf<MFInt32>(*scene, "TOUCH.touch"), ElementsAre(1, 1));
  EXPECT_THAT(valueOf<MFInt32>(*scene, "TOUCH.rigid_touch"), ElementsAre());
}

TEST(ChainWiring, TheSecondDistanceMakesRigid) {
  const auto scene = chainSceneOf(kNearRib + kSheet + contact("TOUCH", "NEAR", "0.2" + kAll));
  EXPECT_EQ(sheetPoint(*scene, 1), Vec3f(1, 0, 0));
  scene->set("TOUCH.dist=0.2 1.2 -100 100 -100");
  EXPECT_THAT(valueOf<MFInt32>(*scene, "TOUCH.rigid_touch"), ElementsAre(1, 0, 1, 1, 1, 3));
  inflate(*scene);
  const Vec3f moved = sheetPoint(*scene, 1) - Vec3f(1, 0, 0);
  EXPECT_LT((sheetPoint(*scene, 0) - Vec3f(0, 0, 0) - moved).norm(), 1e-6f)
      << "rigid with the point that follows";
  EXPECT_LT((sheetPoint(*scene, 3) - Vec3f(1, 0, 1) - moved).norm(), 1e-6f);
}

TEST(ChainWiring, APointFollowsItsRibAtItsOffset) {
  const auto scene = chainSceneOf(kNearRib + kSheet + contact("TOUCH", "NEAR", "0.2" + kAll));
  EXPECT_EQ(sheetPoint(*scene, 1), Vec3f(1, 0, 0)) << "at rest nothing moves";
  inflate(*scene);
  const auto followed = valueOf<MFVec3f>(*scene, "NEAR.rib_points");
  ASSERT_EQ(followed.size(), 1u);
  EXPECT_LT((followed[0] - Vec3f(-0.1f, 1, 0)).norm(), 1e-6f);
  EXPECT_LT((sheetPoint(*scene, 1) - Vec3f(-0.1f, 0.9f, 0)).norm(), 1e-6f);
  EXPECT_EQ(sheetPoint(*scene, 2), Vec3f(0, 0, 1)) << "its links are slack";
}

TEST(ChainWiring, ContactsAreTakenAtRestWheneverTheyAreAskedFor) {
  const auto scene = chainSceneOf(kNearRib + kSheet + contact("TOUCH", "NEAR", "0.2" + kAll));
  inflate(*scene);
  EXPECT_LT((sheetPoint(*scene, 1) - Vec3f(-0.1f, 0.9f, 0)).norm(), 1e-6f);
  scene->set("NEAR.inflation=0.5");
  EXPECT_THAT(valueOf<MFInt32>(*scene, "TOUCH.touch"), ElementsAre(1, 1));
  scene->set("NEAR.inflation=0");
  EXPECT_EQ(sheetPoint(*scene, 1), Vec3f(1, 0, 0)) << "exhale returns to rest";
}

TEST(ChainWiring, PointsAreTakenAsWrittenOrFromTheOrganItself) {
  const auto scene = chainSceneOf(kNearRib + kSheet + contact("TOUCH", "NEAR", "0.2" + kAll) +
                                  "<RotTransform DEF='OWN' dist='0.2 0 -100 100 -100' coord1='1 0.1 0'/>" +
                                  route("SHEET", "deformedCoord", "OWN", "coord2") +
                                  "<RotTransform DEF='WRITTEN' dist='0.2 0 -100 100 -100' coord1='1 0.1 0' "
                                  "coord2='9 9 9 1 0 0'/>");
  inflate(*scene);
  EXPECT_THAT(valueOf<MFInt32>(*scene, "OWN.touch"), ElementsAre(0, 1)) << "at rest";
  EXPECT_THAT(valueOf<MFInt32>(*scene, "WRITTEN.touch"), ElementsAre(0, 1));
}

TEST(ChainWiring, ContactsFollowTheirLimits) {
  const auto scene = chainSceneOf(kNearRib + kSheet + contact("TOUCH", "NEAR", "0.2" + kAll));
  EXPECT_THAT(valueOf<MFInt32>(*scene, "TOUCH.touch"), ElementsAre(1, 1));
  scene->set("TOUCH.dist=1.2 0 -100 100 -100");
  EXPECT_THAT(valueOf<MFInt32>(*scene, "TOUCH.touch"), ElementsAre(1, 0, 1, 1, 1, 3));
  scene->set("TOUCH.dist=1.2 0 0.5 100 -100");
  EXPECT_THAT(valueOf<MFInt32>(*scene, "TOUCH.touch"), ElementsAre(1, 3)) << "least z";
  scene->set("TOUCH.dist=1.2 0 -100 100 0.5");
  EXPECT_THAT(valueOf<MFInt32>(*scene, "TOUCH.touch"), ElementsAre(1, 1, 1, 3)) << "least x";
}

/// A second organ, whose first point lies 0.1 below the sheet's second.
const std::string kLung =
    "<DeformableShape2 DEF='LUNG'><ChainmailDeformer stretchFactor='1000' shearFactor='1000'/>"
    "<IndexedTriangleSet index='0 1 2'><Coordinate DEF='LUNG COORD' point='1 -0.1 0  4 0 0  4 0 1'/>"
    "</IndexedTriangleSet></DeformableShape2><RotTransform DEF='D_LUNG' dist='0.25 0 -100 100 -100'/>";

std::string twoRibs(bool swapped) {
  const std::string near = contact("TOUCH_NEAR", "NEAR", "0.2" + kAll);
  const std::string far = contact("TOUCH_FAR", "FAR", "0.4" + kAll);
  // Above the sheet's first point, and farther than NEAR above its second.
  const std::string farRib = rib("FAR", "0 0.3 0  1 0.35 0  9 9 9");
  return kNearRib + farRib + kSheet + (swapped ? far + near : near + far);
}

TEST(ChainWiring, SourcesAreKeptApart) {
  const auto scene = chainSceneOf(twoRibs(false));
  scene->set("NEAR.inflation=1");
  EXPECT_LT((sheetPoint(*scene, 1) - Vec3f(-0.1f, 0.9f, 0)).norm(), 1e-6f) << "of two, it follows the nearer";
  EXPECT_EQ(sheetPoint(*scene, 0), Vec3f(0, 0, 0));
  scene->set("NEAR.inflation=0");
  scene->set("FAR.inflation=1");
  EXPECT_EQ(sheetPoint(*scene, 1), Vec3f(1, 0, 0));
  EXPECT_LT((sheetPoint(*scene, 0) - Vec3f(-0.3f, -0.3f, 0)).norm(), 1e-6f);
}

TEST(ChainWiring, ARibThatTouchesTwoOrgansMovesEachByItsOwnContacts) {
  const auto scene = chainSceneOf(
      kNearRib + kSheet + kLung + route("NEAR COORD", "point", "D_LUNG", "coord1") +
      route("LUNG COORD", "point", "D_LUNG", "coord2") + route("D_LUNG", "touch", "NEAR", "touch") +
      route("D_LUNG", "touch", "LUNG", "touch_point_to_update") +
      route("NEAR", "rib_points", "LUNG", "points_to_follow") + contact("TOUCH", "NEAR", "1.2" + kAll));
  EXPECT_EQ(valueOf<MFVec3f>(*scene, "NEAR.rib_points").size(), 4u)
      << "one for the lung, three for the sheet";
  EXPECT_EQ(toldBy(*scene), "");
  inflate(*scene);
  const auto lung = valueOf<MFVec3f>(*scene, "LUNG.deformedCoord");
  EXPECT_LT((lung[0] - Vec3f(-0.1f, 0.8f, 0)).norm(), 1e-6f);
  EXPECT_EQ(lung[1], Vec3f(4, 0, 0)) << "no contact of the lung's";
  EXPECT_LT((sheetPoint(*scene, 3) - Vec3f(-0.1f, 0.9f, 1)).norm(), 1e-6f);
}

TEST(ChainWiring, TheOrderOfRoutesDoesNotMatter) {
  const auto one = chainSceneOf(twoRibs(false));
  const auto other = chainSceneOf(twoRibs(true));
  inflate(*one);
  inflate(*other);
  EXPECT_EQ(valueOf<MFVec3f>(*one, "SHEET.deformedCoord"), valueOf<MFVec3f>(*other, "SHEET.deformedCoord"));
}

TEST(ChainWiring, NobodyLooksNothingIsSolved) {
  const auto scene = chainSceneOf(twoRibs(false));
  const auto before = solveCounter();
  for (int k = 1; k <= 10; ++k) {
    scene->tick(k);
    scene->set("NEAR.inflation=0." + std::to_string(k % 10));
  }
  EXPECT_EQ(solveCounter(), before);
  sheetPoint(*scene, 0);
  EXPECT_EQ(solveCounter(), before + 1);
}

TEST(ChainWiring, ALungFollowsTheDiaphragm) {
  const auto follow = [](const std::string& k) {
    const auto scene = chainSceneOf(kNearRib + kSheet + kLung + contact("TOUCH", "NEAR", "0.2" + kAll) +
                                    route("SHEET COORD", "point", "D_LUNG", "coord1") +
                                    route("LUNG COORD", "point", "D_LUNG", "coord2") +
                                    route("D_LUNG", "touch", "SHEET", "coord" + k) +
                                    route("D_LUNG", "touch", "LUNG", "touch_point_to_update") +
                                    route("SHEET", "coord_to_lung" + k, "LUNG", "points_to_follow"));
    EXPECT_EQ(toldBy(*scene), "");
    inflate(*scene);
    const Vec3f lung = valueOf<MFVec3f>(*scene, "LUNG.deformedCoord").at(0);
    EXPECT_LT((lung - (sheetPoint(*scene, 1) - Vec3f(0, 0.1f, 0))).norm(), 1e-6f);
    EXPECT_LT((lung - Vec3f(-0.1f, 0.8f, 0)).norm(), 1e-6f);
  };
  follow("");
  follow("2");
}

TEST(ChainWiring, TheDomeIsInStepWithTheRibs) {
  const auto scene =
      chainSceneOf("<TimeSensor DEF='TS' loop='true' cycleInterval='4'/>" + kNearRib + kSheet +
                   route("TS", "time", "NEAR", "rota") + route("NEAR", "rota", "NEAR", "rotation") +
                   route("TS", "time", "SHEET", "inflation"));
  scene->set("SHEET.dome=3");
  scene->set("SHEET.domeTravel=0 -2 0");
  for (const auto& [time, inflation] : {std::pair(0., 0.5f), {1., 1.f}, {2., 0.5f}, {3., 0.f}, {5., 1.f}}) {
    scene->tick(time);
    EXPECT_LT((sheetPoint(*scene, 3) - Vec3f(1, -2 * inflation, 1)).norm(), 1e-6f) << time;
    EXPECT_NEAR(valueOf<SFRotation>(*scene, "NEAR.rotation").angle, inflation * 1.5707964f, 1e-6f) << time;
  }
}

TEST(ChainWiring, FaultsAreToldWithNodeAndField) {
  const auto told = [](const std::string& elements) {
    const auto scene = chainSceneOf(elements);
    sheetPoint(*scene, 0);
    return toldBy(*scene);
  };
  EXPECT_THAT(told(kNearRib + kSheet + contact("TOUCH", "NEAR", "0.2 1")),
              HasSubstr("TOUCH: dist: five finite numbers are expected"));
  EXPECT_THAT(told(kNearRib + kSheet + contact("TOUCH", "NEAR", "0.02" + kAll)),
              HasSubstr("TOUCH: dist: no point of coord2 is within 0.02 of one of coord1"));
  EXPECT_THAT(told(kNearRib + kSheet + route("NEAR COORD", "point", "SHEET", "points_to_follow")),
              HasSubstr("SHEET: points_to_follow: NEAR COORD.point is no rib_points or coord_to_lung"));
  EXPECT_THAT(
      told(kNearRib + kSheet + route("SHEET", "rigid_points", "SHEET", "dome") +
           route("SHEET", "dome", "NEAR", "touch")),
      HasSubstr("route SHEET.dome TO NEAR.touch: MFInt32 sent where touch or rigid_touch of a RotTransform"));
  EXPECT_THAT(told(kNearRib + kSheet + "<RotTransform DEF='TOUCH'/>" +
                   route("TOUCH", "touch", "SHEET", "touch_point_to_update")),
              HasSubstr("SHEET: touch_point_to_update: nothing in points_to_follow is moved by TOUCH.touch"));
  const auto scene = chainSceneOf(kSheet);
  scene->set("SHEET.dome=4");
  sheetPoint(*scene, 0);
  EXPECT_THAT(toldBy(*scene), HasSubstr("SHEET: dome: there is no point 4 among 4"));
}

TEST(ChainWiring, ContactsRoutedInACircleEnd) {
  const auto scene =
      chainSceneOf("<RotTransform DEF='A'/><RotTransform DEF='B'/>" + route("A", "touch", "B", "touch") +
                   route("B", "touch", "A", "touch") + route("A", "touch", "A", "touch"));
  scene->set("A.dist=1 2 3 4 5");
  EXPECT_THAT(valueOf<MFInt32>(*scene, "A.touch"), ElementsAre());
}

TEST(ChainWiring, ContactsWithACopyOfTheMovedShapeEnd) {
  const auto scene = chainSceneOf(
      kNearRib + kSheet + "<Shape><PointSet><Coordinate DEF='COPY'/></PointSet></Shape>" +
      route("SHEET COORD", "point", "COPY", "point") + "<RotTransform DEF='T' dist='0.2" + kAll + "'/>" +
      route("NEAR COORD", "point", "T", "coord1") + route("COPY", "point", "T", "coord2") +
      route("T", "touch", "NEAR", "touch") + route("T", "touch", "SHEET", "touch_point_to_update") +
      route("NEAR", "rib_points", "SHEET", "points_to_follow"));
  for (int k = 0; k <= 4; ++k) {
    scene->set("NEAR.inflation=" + std::to_string(0.25 * k));
    EXPECT_TRUE(sheetPoint(*scene, 1).allFinite());
    valueOf<MFInt32>(*scene, "T.touch");
    valueOf<MFVec3f>(*scene, "NEAR.rib_points");
  }
}

TEST(ChainWiring, BothLibrariesInOneSceneAreAFault) {
  const auto scene = chainSceneOf("<ImportLibrary library='\"thorax\"'/>" + kSheet);
  EXPECT_THAT(toldBy(*scene), HasSubstr("library thorax: node type ChainmailDeformer is registered twice"));
  EXPECT_EQ(sheetPoint(*scene, 1), Vec3f(1, 0, 0)) << "the first one serves";
}

}  // namespace
}  // namespace pleura
