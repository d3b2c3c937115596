#include <gtest/gtest.h>

#include <pleura/nodes/deformable/solve_counter.h>
#include <pleura/tests/nodes/thorax/nodes/thorax_scene.h>
#include <pleura/tests/x3d/temporary_folder.h>
#include <pleura/x3d/browser/view/scene_view.h>

namespace pleura {
namespace {

/// How often a deformer runs in ten ticks that are looked at, once all is bound.
std::uint64_t solvesOfTenTicks(Scene& scene) {
  SceneView view(scene);
  scene.tick(0);
  view.update();
  const auto before = solveCounter();
  for (int k = 1; k <= 10; ++k) {
    scene.tick(k * 0.1);
    view.update();
  }
  return solveCounter() - before;
}

TEST(Laziness, WhatIsSeenIsSolvedOnceATick) {
  const auto all = breathingThorax();
  const auto withoutLungs = breathingThorax();
  withoutLungs->set("LUNG_L.visible=false");
  withoutLungs->set("LUNG_R.visible=false");
  EXPECT_EQ(solvesOfTenTicks(*all), solvesOfTenTicks(*withoutLungs) + std::size_t{2} * 10);
}

TEST(Laziness, AHiddenThoraxSolvesNothing) {
  const auto scene = breathingThorax();
  scene->set("THORAX.visible=false");
  EXPECT_EQ(solvesOfTenTicks(*scene), 0u);
}

TEST(Laziness, NobodyLooksAndNothingIsSolved) {
  const auto scene = breathingThorax();
  const auto before = solveCounter();
  for (int k = 0; k <= 10; ++k) scene->tick(k * 0.1);
  EXPECT_EQ(solveCounter(), before);
}

TEST(Laziness, APausedThoraxSolvesNothing) {
  const auto scene = breathingThorax();
  scene->set("BREATH.paused=true");
  EXPECT_EQ(solvesOfTenTicks(*scene), 0u);
}

TEST(Laziness, AnOrganThatIsShownAgainIsWhereItBelongs) {
  const auto hidden = breathingThorax();
  const auto shown = breathingThorax();
  hidden->set("LUNG_L.visible=false");
  solvesOfTenTicks(*hidden);
  solvesOfTenTicks(*shown);
  hidden->set("LUNG_L.visible=true");
  for (auto* scene : {hidden.get(), shown.get()}) scene->tick(1.3);
  EXPECT_EQ(valueOf<MFVec3f>(*hidden, "LUNG_L.deformedCoord"),
            valueOf<MFVec3f>(*shown, "LUNG_L.deformedCoord"));
}

TEST(Laziness, NothingIsBegunThatNobodySees) {
  const auto scene = breathingThorax();
  scene->set("LUNG_L.visible=false");
  SceneView view(*scene);
  scene->tick(0);
  view.update();
  const auto before = valueOf<MFVec3f>(*scene, "LUNG_L.deformedCoord");
  scene->tick(1);
  view.update();
  EXPECT_FALSE(scene->field("LUNG_L.deformedCoord").isUpToDate());
  EXPECT_TRUE(scene->field("LUNG_R.deformedCoord").isUpToDate());
}

TEST(Laziness, RibsAloneLoadNoOrgan) {
  const TemporaryFolder folder;
  std::filesystem::copy(sceneFolder() / "anatomy/rib_l5.x3d", folder.path() / "rib_l5.x3d");
  Scene scene;
  scene.load(folder.write(
      "ribs.x3d",
      "<Scene><ImportLibrary library='\"thorax\"'/><Respiration DEF='BREATH'/>"
      "<RotTransform DEF='RIB' angles='0.2 0.2 1'><Inline url='\"rib_l5.x3d\"'/></RotTransform>"
      "<ROUTE fromNode='BREATH' fromField='inflation' toNode='RIB' toField='inflation'/></Scene>"));
  EXPECT_EQ(scene.diagnostics().all().size(), 0u);
  EXPECT_EQ(solvesOfTenTicks(scene), 0u);
  EXPECT_GT(valueOf<SFRotation>(scene, "RIB.rotation").angle, 0.01);
}

}  // namespace
}  // namespace pleura
