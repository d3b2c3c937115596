#pragma once

#include <atomic>
#include <cstddef>
#include <fstream>
#include <vector>

#include <pleura/haptics/recorded/recording.h>

namespace pleura::haptics {

/// Writes a recording while a haptic loop runs: the loop's thread adds, the owner's thread flushes, and
/// neither waits for the other.
class RecordingWriter {
 public:
  /// A minute at 1 kHz.
  static constexpr std::size_t kCapacity = 60'000;

  /// Creates the file. `capacity` >= 1 is how many ticks fit between two flushes; memory for them is taken
  /// here. Throws RecordingError.
  RecordingWriter(const std::filesystem::path& file, const DeviceCapabilities& capabilities,
                  std::size_t capacity = kCapacity);
  /// Flushes, come what may.
  ~RecordingWriter();
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// Loop's thread; never blocks or allocates. False: the owner flushed too late. The recording ends there:
  /// one with a gap would not be what happened.
  bool add(const RecordedTick& tick) noexcept;

  /// Owner's thread: writes what was added. Throws RecordingError when the file can't take it.
  void flush();

  bool isCutOff() const { return isCutOff_; }

 private:
  std::filesystem::path file_;
  std::ofstream out_;
  std::vector<RecordedTick> ring_;
  std::atomic<std::size_t> added_ = 0;    // written by the loop only
  std::atomic<std::size_t> flushed_ = 0;  // written by the owner only
  std::atomic<bool> isCutOff_ = false;
};

}  // namespace pleura::haptics
