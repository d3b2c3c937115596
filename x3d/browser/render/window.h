#pragma once

#include <functional>
#include <memory>
#include <string>

#include <Eigen/Core>

#include <pleura/x3d/browser/render/gl_context.h>

namespace pleura::render {

enum class Action { Release, Press, Repeat };

struct Modifiers {
  bool shift = false, control = false, alt = false;
};

/// A key by GLFW's code: printable keys are the capital letter or digit they bear on a US keyboard.
struct KeyEvent {
  int key = 0;
  Action action = Action::Press;
  Modifiers modifiers;
};

enum class MouseButton { Left, Right, Middle };

struct MouseButtonEvent {
  MouseButton button = MouseButton::Left;
  Action action = Action::Press;
  Modifiers modifiers;
  Eigen::Vector2f position;  // [pixel from the top left]
};

/// Any button held makes it a drag.
struct MouseMoveEvent {
  Eigen::Vector2f position;  // [pixel from the top left]
  Eigen::Vector2f movement;  // since the last event [pixel]
  bool left = false, right = false, middle = false;
  Modifiers modifiers;
};

/// What a window tells from within Window::poll(); set those you need.
struct WindowEvents {
  std::function<void(const KeyEvent&)> key;
  std::function<void(char32_t)> character;  // as typed, in the user's layout
  std::function<void(const MouseButtonEvent&)> mouseButton;
  std::function<void(const MouseMoveEvent&)> mouseMove;
  std::function<void(float steps)> scroll;
  std::function<void(const Eigen::Vector2i& size)> resize;  // of the picture [pixel]
  std::function<void(bool gained)> focus;
};

/// A window with the machine's own OpenGL. One at a time, in the main thread. All pixels are the picture's,
/// also on displays where the desktop counts in larger ones.
class Window {
 public:
  /// Opens it. Throws std::runtime_error that says why it can't: no display, no OpenGL 3.3.
  Window(int width, int height, const std::string& title);
  ~Window();

  WindowEvents events;

  /// For a Renderer: draw(), present(), then swapBuffers() show a frame.
  GlContext& context();
  Eigen::Vector2i size() const;  // of the picture [pixel]

  /// Delivers the events that wait. Throws what a callback threw.
  void poll();
  void swapBuffers();
  bool closeRequested() const;
  void requestClose();
  void setTitle(const std::string& title);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pleura::render
