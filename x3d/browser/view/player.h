#pragma once

#include <optional>
#include <string>

#include <pleura/x3d/browser/render/orbit_camera.h>
#include <pleura/x3d/browser/render/renderer.h>
#include <pleura/x3d/browser/render/window.h>
#include <pleura/x3d/browser/scene/scene.h>
#include <pleura/x3d/browser/touch/touch_session.h>
#include <pleura/x3d/browser/view/scene_view.h>

namespace pleura {

/// A scene in a window, on the real clock. The mouse orbits (left), pans (right or middle) and zooms (wheel);
/// Page Up and Page Down go through the viewpoints, Home goes back to the viewpoint, Escape closes. Every key
/// is also the scene's. Where the scene has a Respiration named BREATH, arrows change its rate (left, right)
/// and depth (up, down), and the title shows them.
class Player {
 public:
  /// Throws std::runtime_error when there is no display, haptics::DeviceError for a device asked for that
  /// there is not.
  Player(Scene& scene, const TouchOptions& touch, int width, int height, const std::string& title);

  /// Until the window is closed, or for so many seconds if above 0.
  void run(double seconds);

 private:
  void onKey(const render::KeyEvent& event);
  void onCharacter(char32_t character);
  void onMove(const render::MouseMoveEvent& event);
  void steer(int key);
  void nextViewpoint(int step);
  void drawFrame();
  void showBreath();
  /// The viewpoint's camera as the mouse moves it.
  render::OrbitCamera& camera();

  Scene& scene_;
  SFFloat* rate_;   // of BREATH; null where there is none
  SFFloat* depth_;  // the same
  SFBool* paused_;  // the same
  TouchSession touch_;
  SceneView view_;
  std::string title_;
  std::string breath_;  // as the title shows it
  render::Window window_;
  render::Renderer renderer_;
  std::optional<render::OrbitCamera> camera_;  // none: the viewpoint's own
};

}  // namespace pleura
