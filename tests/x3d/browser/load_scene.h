#pragma once

#include <memory>
#include <string>

#include <pleura/tests/x3d/temporary_folder.h>
#include <pleura/x3d/browser/scene/scene.h>

namespace pleura {

/// A scene of these elements.
inline std::unique_ptr<Scene> sceneOf(const std::string& elements) {
  const TemporaryFolder folder;
  auto scene = std::make_unique<Scene>();
  scene->load(folder.write("s.x3d", "<Scene>" + elements + "</Scene>"));
  return scene;
}

/// A scene with nothing but a breath, and keys that reach it.
inline std::unique_ptr<Scene> sceneOfABreath(const std::string& attributes = {}) {
  return sceneOf("<ImportLibrary library='\"thorax\"'/><Respiration DEF='BREATH' " + attributes +
                 "/><KeySensor DEF='KEYS'/>"
                 "<ROUTE fromNode='KEYS' fromField='keyPress' toNode='BREATH' toField='keyPress'/>");
}

template <class FieldClass>
typename FieldClass::value_type valueOf(Scene& scene, const std::string& path) {
  return dynamic_cast<FieldClass&>(scene.field(path)).getValue();
}

inline void press(Scene& scene, const std::string& character) {
  KeyEvent event{.character = character};
  scene.key(event);
  event.pressed = false;
  scene.key(event);
}

}  // namespace pleura
