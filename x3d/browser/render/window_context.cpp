#include <stdexcept>

#include <pleura/x3d/browser/render/window_context.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace pleura::render {
namespace {

[[noreturn]] void fail() {
  const char* reason = nullptr;
  glfwGetError(&reason);
  const std::string message = std::string("no window: ") + (reason ? reason : "GLFW does not say why");
  glfwTerminate();
  throw std::runtime_error(message);
}

}  // namespace

WindowContext::WindowContext(int width, int height, const std::string& title) {
  if (width < 1 || height < 1) throw std::invalid_argument("a window's sides must be at least 1");
  if (!glfwInit()) fail();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!window_) fail();
  makeCurrent();
  glfwSwapInterval(1);
}

WindowContext::~WindowContext() { glfwTerminate(); }  // its window goes with it

void WindowContext::makeCurrent() { glfwMakeContextCurrent(window_); }

GlFunction WindowContext::getProcAddress(const char* name) const { return glfwGetProcAddress(name); }

Eigen::Vector2i WindowContext::size() const {
  Eigen::Vector2i size(0, 0);
  glfwGetFramebufferSize(window_, &size.x(), &size.y());
  return size;
}

}  // namespace pleura::render
