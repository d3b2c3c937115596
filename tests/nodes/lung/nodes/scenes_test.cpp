#include <gtest/gtest.h>

#include <pleura/tests/nodes/deformable/in_threads.h>
#include <pleura/tests/nodes/lung/nodes/lung_scene.h>
#include <pleura/x3d/browser/scene/state_hash.h>
#include <pleura/x3d/browser/view/scene_view.h>

namespace pleura {
namespace {

/// Each scene that comes with Pleura: without a fault, and the same bits whenever it runs.
TEST(Scenes, RunWithoutAFaultAndRepeatably) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(sceneFolder())) {
    if (entry.path().extension() != ".x3d") continue;
    ++count;
    const auto run = [&] {
      Scene scene;
      scene.load(entry.path());
      for (int k = 0; k < 4; ++k) scene.tick(0.1 * k);
      const auto hash = stateHash(scene);
      for (const auto& each : scene.diagnostics().all()) ADD_FAILURE() << toText(each);
      return hash;
    };
    EXPECT_EQ(run(), run()) << entry.path();
  }
  EXPECT_GE(count, 5);
}

/// Lungs of finite elements, seen at each tick, are solved side by side where there are threads for it.
TEST(Scenes, AreTheSameBitsInAnyNumberOfThreads) {
  const auto run = [](int threads) {
    const InThreads all(threads);
    Scene scene;
    scene.load(sceneFolder() / "finite_element_lung.x3d");
    for (const char* tissue : {"TISSUE_L", "TISSUE_R"}) {
      scene.set(std::string(tissue) + ".elements=60");
      scene.set(std::string(tissue) + ".model=COROTATIONAL");
    }
    SceneView view(scene);
    for (int k = 0; k < 8; ++k) {
      scene.tick(0.2 * k);
      view.update();
    }
    return stateHash(scene);
  };
  const auto inOne = run(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(run(threads), inOne) << threads;
}

}  // namespace
}  // namespace pleura
