#include <gtest/gtest.h>

#include <pleura/tests/nodes/lung/nodes/lung_scene.h>
#include <pleura/x3d/browser/scene/state_hash.h>

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

}  // namespace
}  // namespace pleura
