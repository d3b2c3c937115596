#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/lung/mechanics/respiratory_units.h>
#include <pleura/tests/nodes/lung/nodes/lung_scene.h>
#include <pleura/tests/x3d/browser/load_scene.h>

namespace pleura {
namespace {

std::unique_ptr<Scene> lesson() {
  auto scene = std::make_unique<Scene>();
  scene->load(sceneFolder() / "lung_2d.x3d");
  scene->tick(0);
  return scene;
}

TEST(PlanarChestNode, BreathesCollapsesAndIsDrawnOut) {
  const auto scene = lesson();
  const auto number = [&](const std::string& field) { return valueOf<SFFloat>(*scene, field); };
  double now = 0, least = 1, most = 0, lowest = 0;
  runOn(*scene, now, 7.9, [&] {
    if (now < 4) return;
    least = std::min<double>(least, number("LEFT.lungVolume"));
    most = std::max<double>(most, number("LEFT.lungVolume"));
    lowest = std::min<double>(lowest, number("LEFT.intrapleuralPressure") / kCmH2O);
  });
  EXPECT_GT(most - least, 0.15e-3) << "m^3: half of a quiet breath";
  EXPECT_LT(most - least, 0.35e-3);
  EXPECT_LT(lowest, -6);
  EXPECT_GT(lowest, -9);
  const auto intact = valueOf<MFInt32>(*scene, "LEFT.wallIndex").size();
  runOn(*scene, now, 19, [&] { number("LEFT.lungVolume"); });
  EXPECT_EQ(number("LEFT.intrapleuralPressure"), 0);
  EXPECT_LT(number("LEFT.lungVolume"), 0.85 * least);
  EXPECT_LT(number("RIGHT.intrapleuralPressure"), -4 * kCmH2O) << "the other lung breathes on";
  EXPECT_LT(valueOf<MFInt32>(*scene, "LEFT.wallIndex").size(), intact) << "the wound is a gap in the wall";
  runOn(*scene, now, 32, [&] { number("LEFT.lungVolume"); });
  EXPECT_NEAR(number("LEFT.lungVolume"), number("RIGHT.lungVolume"), 1e-5) << "a twentieth more air is left";
  for (const auto& each : scene->diagnostics().all()) ADD_FAILURE() << toText(each);
}

TEST(PlanarChestNode, ASecondLungIsAddedInTheFileAlone) {
  for (const int count : {0, 1, 2}) {
    std::string lungs;
    for (int k = 0; k < count; ++k)
      lungs += k == 0 ? "<PlanarLung DEF='L0'/>" : "<PlanarLung DEF='L1' isRight='true'/>";
    const auto scene = sceneOf("<ImportLibrary library='\"lung\"'/><PlanarChest DEF='CHEST' effort='1'>" +
                               lungs + "</PlanarChest>");
    double now = 0;
    runOn(*scene, now, 1, [&] { valueOf<SFFloat>(*scene, "CHEST.diaphragmDescent"); });
    EXPECT_GT(valueOf<SFFloat>(*scene, "CHEST.diaphragmDescent"), 0.001f) << count;
    for (const auto& each : scene->diagnostics().all()) ADD_FAILURE() << toText(each);
  }
}

TEST(PlanarChestNode, WhatMakesNoChestIsTold) {
  for (const char* bad : {"<PlanarChest DEF='CHEST' chestWall='0 1 1'><PlanarLung/></PlanarChest>",
                          "<PlanarChest DEF='CHEST' diaphragm='1 1 0'/>"}) {
    const auto scene = sceneOf("<ImportLibrary library='\"lung\"'/>" + std::string(bad));
    scene->tick(1);
    ASSERT_EQ(scene->diagnostics().all().size(), 1u) << bad;
    EXPECT_THAT(scene->diagnostics().all()[0].message, testing::StartsWith("CHEST: "));
    EXPECT_EQ(valueOf<SFFloat>(*scene, "CHEST.diaphragmDescent"), 0);
  }
}

}  // namespace
}  // namespace pleura
