#pragma once

#include <memory>
#include <string>

#include <pleura/tests/x3d/browser/load_scene.h>

namespace pleura {

inline const std::filesystem::path& sceneFolder() {
  static const std::filesystem::path folder = std::filesystem::path(PLEURA_SOURCE_DIR) / "scenes";
  return folder;
}

inline std::unique_ptr<Scene> breathingThorax() {
  auto scene = std::make_unique<Scene>();
  scene->load(sceneFolder() / "breathing_thorax.x3d");
  return scene;
}

}  // namespace pleura
