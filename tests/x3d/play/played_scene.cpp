#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <pleura/tests/x3d/play/played_scene.h>

namespace pleura {

Picture Picture::columns(int begin, int end) const {
  Picture part{end - begin, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = begin; x < end; ++x) part.pixels.push_back(pixels[static_cast<std::size_t>(y * width + x)]);
  return part;
}

struct PlayedScene::Display {
  ::Display* x = XOpenDisplay(nullptr);
  Window window = 0;

  Display() {
    if (x == nullptr) throw std::runtime_error("no X display");
    // A window that has gone makes calls fail; Xlib would end the process.
    XSetErrorHandler([](::Display*, XErrorEvent*) { return 0; });
  }
  ~Display() { XCloseDisplay(x); }
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  std::string titleOf(Window of) const {
    char* name = nullptr;
    if (XFetchName(x, of, &name) == 0 || name == nullptr) return {};
    std::string title = name;
    XFree(name);
    return title;
  }

  bool isVisible(Window of) const {
    XWindowAttributes attributes;
    return XGetWindowAttributes(x, of, &attributes) != 0 && attributes.map_state == IsViewable;
  }

  /// Takes the first window on screen whose title starts like that.
  bool find(const std::string& title) {
    Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    if (XQueryTree(x, DefaultRootWindow(x), &root, &parent, &children, &count) == 0) return false;
    for (unsigned i = 0; i < count; ++i)
      if (titleOf(children[i]).starts_with(title) && isVisible(children[i])) window = children[i];
    if (children != nullptr) XFree(children);
    return window != 0;
  }

  /// Keys and mouse as the X server gets them from devices.
  void type(const std::string& what) const {
    XSetInputFocus(x, window, RevertToParent, CurrentTime);
    XSync(x, False);
    if (std::system(("xdotool " + what).c_str()) != 0) throw std::runtime_error("xdotool " + what);
  }
  std::string moveToMiddle() const { return "mousemove --window " + std::to_string(window) + " 160 120 "; }
};

PlayedScene::PlayedScene(const std::filesystem::path& scene) : display_(std::make_unique<Display>()) {
  std::string words[] = {PLEURA_PROGRAM, "play", scene.string(), "--width", "320", "--height", "240"};
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  if (posix_spawn(&program_, PLEURA_PROGRAM, nullptr, nullptr, arguments.data(), environ) != 0)
    throw std::runtime_error("can't start " PLEURA_PROGRAM);
  if (!eventually([&] { return display_->find("Pleura - " + scene.filename().string()); }))
    throw std::runtime_error("no window of " + scene.string());
}

PlayedScene::~PlayedScene() {
  if (program_ < 0) return;
  ::kill(program_, SIGKILL);
  ::waitpid(program_, nullptr, 0);
}

std::string PlayedScene::title() const {
  std::string title = display_->titleOf(display_->window);
  if (title.empty()) throw std::runtime_error("the window is gone");
  return title;
}

Picture PlayedScene::picture() const {
  Picture picture{320, 240, {}};
  XImage* image = XGetImage(display_->x, display_->window, 0, 0, 320, 240, AllPlanes, ZPixmap);
  if (image == nullptr) throw std::runtime_error("the window is gone");
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      picture.pixels.push_back(static_cast<std::uint32_t>(XGetPixel(image, x, y) & 0xFFFFFF));
  XDestroyImage(image);
  return picture;
}

void PlayedScene::press(const std::string& key) { display_->type("key " + key); }

void PlayedScene::drag(int button, int right, int down) {
  const std::string held = std::to_string(button);
  display_->type(display_->moveToMiddle() + "mousedown " + held + " mousemove_relative -- " +
                 std::to_string(right) + " " + std::to_string(down) + " mouseup " + held);
}

void PlayedScene::turnWheel(int steps) {
  for (int i = 0; i < std::abs(steps); ++i)
    display_->type(display_->moveToMiddle() + "click " + (steps > 0 ? "5" : "4"));
}

void PlayedScene::close() {
  XEvent message{};
  message.xclient.type = ClientMessage;
  message.xclient.window = display_->window;
  message.xclient.message_type = XInternAtom(display_->x, "WM_PROTOCOLS", False);
  message.xclient.format = 32;
  message.xclient.data.l[0] = static_cast<long>(XInternAtom(display_->x, "WM_DELETE_WINDOW", False));
  XSendEvent(display_->x, display_->window, False, NoEventMask, &message);
  XFlush(display_->x);
}

int PlayedScene::exitStatus() {
  int status = 0;
  if (!eventually([&] { return ::waitpid(program_, &status, WNOHANG) == program_; })) return -1;
  program_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace pleura
