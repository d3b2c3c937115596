#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <pleura/haptics/servo/servo_loop.h>
#include <pleura/nodes/haptic/device_info.h>
#include <pleura/x3d/browser/touch/device_outputs.h>
#include <pleura/x3d/browser/touch/touch_scene.h>

namespace pleura {

/// What is asked for beside what the scene says.
struct TouchOptions {
  std::string device = {};            // driver; empty: the one that the scene names
  std::filesystem::path stylus = {};  // path of the simulated stylus, or recording; empty: the scene's
  std::filesystem::path record = {};  // where the first device's session is recorded; empty: nowhere

  bool isEmpty() const { return device.empty() && stylus.empty() && record.empty(); }
};

/// A scene's haptic devices at work: each tick the scene is handed to them, and what they tell comes back as
/// fields. On the virtual clock the haptic ticks run in advance(), the same bits in every run; on the real
/// one each device has a loop of its own.
class TouchSession {
 public:
  enum class Clock { virtualTime, real };

  /// Looks for the devices of the scene's bound DeviceInfo; none, and no device asked for: nothing ever
  /// happens. Where a device is asked for and the scene has none, it gets one named STYLUS. Throws
  /// haptics::DeviceError for a driver that there is not, and for a bad path of the stylus.
  TouchSession(Scene& scene, const TouchOptions& options, Clock clock);
  ~TouchSession();

  /// Opens the devices. One that can't be opened is told to the scene's author and tried again every second;
  /// the one that was asked for throws haptics::DeviceError.
  void open();

  /// After the scene's tick: brings touch to the same moment `now` [s]. Throws haptics::RecordingError when
  /// the recording can't be written.
  void advance(Time now);

  bool hasDevices() const { return !hands_.empty(); }
  const TouchScene& touchScene() const { return touchScene_; }

  /// How the loops keep time, and what was counted; of the first device.
  struct Statistics {
    std::int64_t ticks = 0;
    std::int64_t missed = 0;
    double p50 = 0, p99 = 0, p999 = 0, longest = 0;  // [s] of the period; 0 on the virtual clock
    std::uint64_t treesBuilt = 0, treesRefitted = 0;
  };
  Statistics statistics() const;

 private:
  struct Hand;

  void adopt(const TouchOptions& options);
  haptics::DeviceSettings settingsOf(Hand& hand) const;
  /// Throws haptics::DeviceError with what each driver said.
  void open(Hand& hand, Time now);
  void openFirst(Hand& hand);
  void tryToOpen(Hand& hand, Time now);
  void lose(Hand& hand, Time now);
  void publish(Hand& hand, double duration);
  void hear(Hand& hand, std::size_t index, Time now);
  void tellParts(const haptics::ServoReport& report, std::size_t index);
  TouchedPart touchedBy(const haptics::ServoReport& report) const;

  Scene& scene_;
  Clock clock_;
  TouchScene touchScene_;
  std::vector<NodePtr> devices_;  // of hands_, kept alive
  std::vector<std::unique_ptr<Hand>> hands_;
  std::vector<bool> isTold_;  // of each part: its outputs say that it is touched
  Time last_ = 0;
  bool isFirst_ = true;
};

}  // namespace pleura
