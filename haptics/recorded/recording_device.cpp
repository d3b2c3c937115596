#include <utility>

#include <pleura/haptics/recorded/recording_device.h>

namespace pleura::haptics {

RecordingDevice::RecordingDevice(std::unique_ptr<HapticDevice> device, std::filesystem::path file,
                                 std::size_t capacity)
    : device_(std::move(device)), file_(std::move(file)), capacity_(capacity) {}

void RecordingDevice::open() {
  device_->open();
  if (writer_) return;
  try {
    writer_.emplace(file_, device_->capabilities(), capacity_);
  } catch (const RecordingError&) {
    device_->close();
    throw;
  }
}

bool RecordingDevice::read(double time, DeviceState& state) noexcept {
  if (!device_->read(time, state)) return false;
  tick_.time = time;
  tick_.state = state;
  return true;
}

bool RecordingDevice::write(const DeviceForce& force) noexcept {
  if (!device_->write(force)) return false;
  tick_.force = force;
  writer_->add(tick_);
  return true;
}

void RecordingDevice::flush() {
  if (!writer_) return;
  writer_->flush();
  if (writer_->isCutOff())
    throw RecordingError(file_.string() + ": the recording ended early: it was not flushed in time");
}

}  // namespace pleura::haptics
