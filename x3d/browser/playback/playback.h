#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <pleura/x3d/browser/playback/key_script.h>
#include <pleura/x3d/browser/playback/tick_statistics.h>
#include <pleura/x3d/browser/playback/watch_table.h>
#include <pleura/x3d/browser/scene/scene.h>
#include <pleura/x3d/browser/touch/touch_session.h>

namespace pleura {

/// What `run` and `render` are asked to do with a scene.
struct PlaybackOptions {
  double step = 1.0 / 30;               // [s] of the virtual clock
  std::vector<std::string> set = {};    // "DEF.field=VALUE", before the first tick
  std::string keys = {};                // see parseKeys
  std::vector<std::string> watch = {};  // "DEF.field"
  std::filesystem::path csv = {};       // where the watched fields go; empty: nowhere
  TouchOptions touch = {};
  bool isRealTime =
      false;  // each tick waits for its time on the real clock, haptic loops have threads of their own
};

/// A scene moved along by a virtual clock from time 0: keys at their times, touch, a row of the table a step,
/// costs counted. Ticks are at k * step, so that nothing drifts and every run is the same.
class Playback {
 public:
  /// Throws std::invalid_argument, UnknownNameError, FieldError, FileError, haptics::DeviceError for options
  /// that do not fit the scene.
  Playback(Scene& scene, const PlaybackOptions& options);

  /// Ticks until `time` [s] inclusive. `afterTick` sees the scene at each, within the tick's measured cost;
  /// what it reads is what the scene computes. Throws FileError when the table can't be written.
  void runUntil(Time time, const std::function<void(Time)>& afterTick = {});

  Time now() const { return static_cast<double>(ticks_) * step_; }
  const TickStatistics& statistics() const { return statistics_; }
  const TouchSession& touch() const { return touch_; }

 private:
  /// Sleeps until that moment of the real clock, counted from the first tick.
  void await(Time now);
  void tick(Time now, const std::function<void(Time)>& afterTick);

  Scene& scene_;
  double step_;
  std::vector<TimedKey> keys_;
  std::size_t nextKey_ = 0;
  TouchSession touch_;  // before the table: it may bring a node to watch
  WatchTable table_;
  std::filesystem::path csvFile_;
  std::ofstream csv_;
  std::int64_t ticks_ = -1;
  bool isRealTime_;
  std::chrono::steady_clock::time_point start_;
  TickStatistics statistics_;
};

}  // namespace pleura
