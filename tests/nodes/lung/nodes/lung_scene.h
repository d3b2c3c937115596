#pragma once

#include <memory>
#include <string>

#include <pleura/tests/nodes/thorax/nodes/thorax_scene.h>

namespace pleura {

/// The breathing thorax with its pleural spaces; on real meshes where `anatomy` is not empty.
inline std::unique_ptr<Scene> pneumothoraxScene(const std::filesystem::path& anatomy = {}) {
  auto scene = std::make_unique<Scene>();
  ReaderLimits limits;
  limits.anatomyFolder = anatomy;
  scene->load(sceneFolder() / "pneumothorax.x3d", limits);
  return scene;
}

constexpr double kTick = 1.0 / 30;  // [s]

/// Ticks on to `until` [s], calling see() after each.
template <class See>
void runOn(Scene& scene, double& now, double until, See see) {
  for (; now < until - kTick / 2; see()) scene.tick(now += kTick);
}

}  // namespace pleura
