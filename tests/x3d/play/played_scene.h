#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <sys/types.h>

namespace pleura {

/// What a window shows.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;  // row by row from the top left, 0xRRGGBB

  /// The columns from `begin` until before `end`.
  Picture columns(int begin, int end) const;
  friend bool operator==(const Picture&, const Picture&) = default;
};

/// The program, playing a scene in a window of 320 x 240 on the X display, with a user's hands on keys and
/// mouse. Ended with the object.
class PlayedScene {
 public:
  /// Waits for the window. Throws std::runtime_error when none comes.
  explicit PlayedScene(const std::filesystem::path& scene);
  ~PlayedScene();
  PlayedScene(const PlayedScene&) = delete;
  PlayedScene& operator=(const PlayedScene&) = delete;

  /// Both throw std::runtime_error when the window is gone.
  std::string title() const;
  Picture picture() const;

  /// A key by its X name: p, Left, Prior, ...
  void press(const std::string& key);
  /// From the window's middle with the button held: 1 left, 2 middle, 3 right.
  void drag(int button, int right, int down);
  /// Towards the user, or away from him below 0.
  void turnWheel(int steps);
  /// As the window's close button does it.
  void close();

  /// Waits for the end: exit status, 128 + signal, or -1 when it does not end.
  int exitStatus();

 private:
  struct Display;
  std::unique_ptr<Display> display_;
  pid_t program_ = -1;
};

/// Asks again and again for up to a minute whether it is so.
template <class Condition>
bool eventually(const Condition& isSo) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!isSo()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

}  // namespace pleura
