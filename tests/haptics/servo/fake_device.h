#pragma once

#include <functional>
#include <vector>

#include <pleura/haptics/device/haptic_device.h>

namespace pleura::haptics {

/// A device that is wherever the test says, and remembers what it was given.
class FakeDevice : public HapticDevice {
 public:
  FakeDevice() {
    capabilities_.model = "fake";
    capabilities_.maxForce = 5;
    capabilities_.maxStiffness = 1000;
    capabilities_.maxDamping = 5;
    capabilities_.workspaceRadius = 1;
  }

  std::function<DeviceState(double)> state = [](double) { return DeviceState(); };
  bool isThere = true;
  std::vector<DeviceForce> given;
  DeviceCapabilities capabilities_;

  const DeviceCapabilities& capabilities() const override { return capabilities_; }
  void open() override {}
  void close() noexcept override {}
  bool read(double time, DeviceState& out) noexcept override {
    if (isThere) out = state(time);
    return isThere;
  }
  bool write(const DeviceForce& force) noexcept override {
    if (isThere) given.push_back(force);
    return isThere;
  }
};

}  // namespace pleura::haptics
