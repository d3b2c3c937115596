#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <pleura/tests/x3d/temporary_folder.h>
#include <pleura/x3d/browser/scene/scene.h>

namespace pleura {

inline std::filesystem::path chainFolder() {
  return std::filesystem::path(PLEURA_SOURCE_DIR) / "scenes/chain";
}

inline std::unique_ptr<Scene> loaded(const std::filesystem::path& file) {
  auto scene = std::make_unique<Scene>();
  scene->load(file);
  return scene;
}

inline std::unique_ptr<Scene> chainThorax() { return loaded(chainFolder() / "thorax.x3d"); }

/// A scene of these elements that has loaded the library.
inline std::unique_ptr<Scene> chainSceneOf(const std::string& elements) {
  const TemporaryFolder folder;
  return loaded(
      folder.write("s.x3d", "<Group><ImportLibrary library='\"chain.dll\"'/>" + elements + "</Group>"));
}

template <class FieldClass>
typename FieldClass::value_type valueOf(Scene& scene, const std::string& path) {
  return dynamic_cast<FieldClass&>(scene.field(path)).getValue();
}

/// Every diagnostic, one a line.
inline std::string toldBy(const Scene& scene) {
  std::string text;
  for (const auto& each : scene.diagnostics().all()) text += toText(each) + "\n";
  return text;
}

inline void pressActionKey(Scene& scene, int key) {
  KeyEvent event{.kind = KeyEvent::Kind::action, .character = {}, .action = key};
  scene.key(event);
  event.pressed = false;
  scene.key(event);
}

}  // namespace pleura
