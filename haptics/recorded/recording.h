#pragma once

#include <filesystem>
#include <vector>

#include <pleura/haptics/device/haptic_device.h>

namespace pleura::haptics {

/// A file that is no recording, or can't be written. what() names the file and, where it is damaged, the
/// byte.
struct RecordingError : DeviceError {
  using DeviceError::DeviceError;
};

/// One tick of a haptic loop: what the device told at `time` [s], and what it was given then.
struct RecordedTick {
  double time = 0;
  DeviceState state;
  DeviceForce force;
};

/// A session with a device.
struct Recording {
  DeviceCapabilities capabilities;
  std::vector<RecordedTick> ticks;
};

/// Every double as it was written, bit for bit. Throws RecordingError on what is cut off or damaged (every
/// tick has a checksum), on states that are not finite, on time that goes backwards, and on more than ten
/// million ticks. A file cut off exactly between two ticks is a shorter recording.
Recording readRecording(const std::filesystem::path& file);

}  // namespace pleura::haptics
