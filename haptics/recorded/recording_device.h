#pragma once

#include <memory>
#include <optional>

#include <pleura/haptics/recorded/recording_writer.h>

namespace pleura::haptics {

/// Another device, whose every tick is recorded: what read() told last, with what write() was given then.
class RecordingDevice : public HapticDevice {
 public:
  /// The file is created by the first open(). `capacity` as RecordingWriter's.
  RecordingDevice(std::unique_ptr<HapticDevice> device, std::filesystem::path file,
                  std::size_t capacity = RecordingWriter::kCapacity);

  const DeviceCapabilities& capabilities() const override { return device_->capabilities(); }
  /// Opened again the recording goes on. Throws DeviceError, RecordingError.
  void open() override;
  void close() noexcept override { device_->close(); }
  bool read(double time, DeviceState& state) noexcept override;
  bool write(const DeviceForce& force) noexcept override;

  /// To be called by the owner's thread, now and then while the loop runs and when it has ended. Throws
  /// RecordingError, also when the recording ended early because this was called too late.
  void flush();

 private:
  std::unique_ptr<HapticDevice> device_;
  std::filesystem::path file_;
  std::size_t capacity_;
  std::optional<RecordingWriter> writer_;
  RecordedTick tick_;
};

}  // namespace pleura::haptics
