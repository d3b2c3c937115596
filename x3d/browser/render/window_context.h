#pragma once

#include <string>

#include <pleura/x3d/browser/render/gl_context.h>

struct GLFWwindow;

namespace pleura::render {

/// The machine's own OpenGL in a GLFW window. One at a time, in the main thread.
class WindowContext : public GlContext {
 public:
  /// Opens the window and makes it current. Throws std::runtime_error with GLFW's reason: no display, no
  /// OpenGL 3.3.
  WindowContext(int width, int height, const std::string& title);
  ~WindowContext() override;

  void makeCurrent() override;
  GlFunction getProcAddress(const char* name) const override;
  Eigen::Vector2i size() const override;

  GLFWwindow* window() const { return window_; }

 private:
  GLFWwindow* window_ = nullptr;
};

}  // namespace pleura::render
