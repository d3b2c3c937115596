#include <exception>
#include <utility>

#include <pleura/x3d/browser/render/window.h>
#include <pleura/x3d/browser/render/window_context.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace pleura::render {
namespace {

Modifiers modifiersOf(int bits) {
  return {(bits & GLFW_MOD_SHIFT) != 0, (bits & GLFW_MOD_CONTROL) != 0, (bits & GLFW_MOD_ALT) != 0};
}

Modifiers modifiersHeld(GLFWwindow* window) {
  const auto held = [window](int left, int right) {
    return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
  };
  return {held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
          held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL), held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
}

bool buttonHeld(GLFWwindow* window, int button) { return glfwGetMouseButton(window, button) == GLFW_PRESS; }

}  // namespace

struct Window::Implementation {
  Implementation(int width, int height, const std::string& title) : context(width, height, title) {}

  /// From screen coordinates, in which GLFW gives the cursor.
  Eigen::Vector2f inPixels(double x, double y) const {
    Eigen::Vector2i screen(1, 1);
    glfwGetWindowSize(context.window(), &screen.x(), &screen.y());
    const Eigen::Vector2f scale =
        context.size().cast<float>().cwiseQuotient(screen.cwiseMax(1).cast<float>());
    return scale.cwiseProduct(Eigen::Vector2f(static_cast<float>(x), static_cast<float>(y)));
  }
  Eigen::Vector2f cursor() const {
    double x = 0, y = 0;
    glfwGetCursorPos(context.window(), &x, &y);
    return inPixels(x, y);
  }

  /// Calls back unless nobody listens. An exception waits for poll(), as it must not pass through GLFW's C
  /// code.
  template <class Callback, class Event>
  void tell(const Callback& callback, const Event& event) {
    if (!callback || thrown) return;
    try {
      callback(event);
    } catch (...) {
      thrown = std::current_exception();
    }
  }

  WindowContext context;
  Eigen::Vector2f lastPosition{0, 0};
  std::exception_ptr thrown;
};

namespace {

Window& windowOf(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

}  // namespace

Window::Window(int width, int height, const std::string& title)
    : implementation_(std::make_unique<Implementation>(width, height, title)) {
  GLFWwindow* window = implementation_->context.window();
  implementation_->lastPosition = implementation_->cursor();
  glfwSetWindowUserPointer(window, this);
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int modifiers) {
    Window& self = windowOf(w);
    self.implementation_->tell(self.events.key,
                               KeyEvent{key, static_cast<Action>(action), modifiersOf(modifiers)});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned codePoint) {
    windowOf(w).implementation_->tell(windowOf(w).events.character, static_cast<char32_t>(codePoint));
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    Window& self = windowOf(w);
    self.implementation_->tell(self.events.mouseButton,
                               MouseButtonEvent{static_cast<MouseButton>(button), static_cast<Action>(action),
                                                modifiersOf(modifiers), self.implementation_->cursor()});
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    Window& self = windowOf(w);
    const Eigen::Vector2f position = self.implementation_->inPixels(x, y);
    const Eigen::Vector2f before = std::exchange(self.implementation_->lastPosition, position);
    self.implementation_->tell(
        self.events.mouseMove,
        MouseMoveEvent{position, position - before, buttonHeld(w, GLFW_MOUSE_BUTTON_LEFT),
                       buttonHeld(w, GLFW_MOUSE_BUTTON_RIGHT), buttonHeld(w, GLFW_MOUSE_BUTTON_MIDDLE),
                       modifiersHeld(w)});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double steps) {
    windowOf(w).implementation_->tell(windowOf(w).events.scroll, static_cast<float>(steps));
  });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int newWidth, int newHeight) {
    windowOf(w).implementation_->tell(windowOf(w).events.resize, Eigen::Vector2i(newWidth, newHeight));
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int gained) {
    windowOf(w).implementation_->tell(windowOf(w).events.focus, gained == GLFW_TRUE);
  });
}

Window::~Window() = default;

GlContext& Window::context() { return implementation_->context; }

Eigen::Vector2i Window::size() const { return implementation_->context.size(); }

void Window::poll() {
  glfwPollEvents();
  if (implementation_->thrown) std::rethrow_exception(std::exchange(implementation_->thrown, nullptr));
}

void Window::swapBuffers() { glfwSwapBuffers(implementation_->context.window()); }

bool Window::closeRequested() const {
  return glfwWindowShouldClose(implementation_->context.window()) == GLFW_TRUE;
}

void Window::requestClose() { glfwSetWindowShouldClose(implementation_->context.window(), GLFW_TRUE); }

void Window::setTitle(const std::string& title) {
  glfwSetWindowTitle(implementation_->context.window(), title.c_str());
}

}  // namespace pleura::render
