#include <bit>
#include <cstdint>
#include <utility>

#include <pleura/haptics/recorded/recorded_device.h>

namespace pleura::haptics {

namespace {

bool isSameVector(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  for (int i = 0; i < 3; ++i)
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  return true;
}

}  // namespace

RecordedDevice::RecordedDevice(Recording recording, PlaybackPace pace)
    : recording_(std::move(recording)), pace_(pace) {
  if (recording_.ticks.empty()) throw RecordingError("the recording has no ticks: there is nothing to play");
}

void RecordedDevice::open() {
  isOpen_ = true;
  hasStarted_ = false;
  tick_ = 0;
  firstDifference_.reset();
}

bool RecordedDevice::read(double time, DeviceState& state) noexcept {
  if (!isOpen_) return false;
  const auto& ticks = recording_.ticks;
  if (!std::exchange(hasStarted_, true)) {
    shift_ = time - ticks.front().time;
  } else if (pace_ == PlaybackPace::ticks) {
    if (tick_ + 1 < ticks.size()) ++tick_;
  } else {
    while (tick_ + 1 < ticks.size() && ticks[tick_ + 1].time <= time - shift_) ++tick_;
  }
  state = ticks[tick_].state;
  return true;
}

bool RecordedDevice::write(const DeviceForce& force) noexcept {
  if (!isOpen_) return false;
  const auto& [time, state, recorded] = recording_.ticks[tick_];
  if (!firstDifference_ &&
      !(isSameVector(force.force, recorded.force) && isSameVector(force.torque, recorded.torque)))
    firstDifference_ = ForceDifference{tick_, time, recorded, force};
  return true;
}

}  // namespace pleura::haptics
