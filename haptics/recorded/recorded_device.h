#pragma once

#include <cstddef>
#include <optional>

#include <pleura/haptics/recorded/recording.h>

namespace pleura::haptics {

/// How a recording is played back.
enum class PlaybackPace {
  time,  // the tick that was the last one then, counted from the first read(): for loops of any rate
  ticks  // a tick for each read(), whatever the time
};

/// The first force that was not what it had been.
struct ForceDifference {
  std::size_t tick = 0;  // counted from 0
  double time = 0;       // [s] in the recording
  DeviceForce recorded;
  DeviceForce given;
};

/// A device that tells what another one told once; forces move nothing. In a loop of the recording's times,
/// or at the pace of its ticks, it gives the same states bit for bit. After the last tick it tells that one.
class RecordedDevice : public HapticDevice {
 public:
  /// Throws RecordingError on a recording without ticks.
  explicit RecordedDevice(Recording recording, PlaybackPace pace = PlaybackPace::time);

  const DeviceCapabilities& capabilities() const override { return recording_.capabilities; }
  /// Back to the first tick.
  void open() override;
  void close() noexcept override { isOpen_ = false; }
  bool read(double time, DeviceState& state) noexcept override;
  bool write(const DeviceForce& force) noexcept override;

  /// Whether the last tick was read.
  bool hasEnded() const { return hasStarted_ && tick_ + 1 == recording_.ticks.size(); }
  /// Since open(), to the last bit; none: the session went as it had.
  const std::optional<ForceDifference>& firstDifference() const { return firstDifference_; }

 private:
  Recording recording_;
  PlaybackPace pace_;
  bool isOpen_ = false;
  bool hasStarted_ = false;
  double shift_ = 0;  // [s] from the recording's time to the loop's
  std::size_t tick_ = 0;
  std::optional<ForceDifference> firstDifference_;
};

}  // namespace pleura::haptics
