#pragma once

#include <cstdint>
#include <stdexcept>

#include <Eigen/Geometry>

#include <pleura/haptics/device/device_capabilities.h>

namespace pleura::haptics {

/// A device that can't be opened, or is described by impossible figures.
struct DeviceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a device tells, in its own frame: +X right, +Y up, +Z towards the user.
struct DeviceState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               // [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  // unit
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();               // [m/s]
  std::uint32_t buttons = 0;                                        // bit k: button k is pressed
};

/// What a device is asked to give, in the same frame.
struct DeviceForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   // [N]
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  // [N m]
};

/// A haptic device: something that a hand holds, tells where it is and pushes back. open() and close() are
/// called by the thread that owns it while no loop runs; read() and write() by the haptic loop only, and they
/// never block, allocate or throw.
class HapticDevice {
 public:
  HapticDevice() = default;
  HapticDevice(const HapticDevice&) = delete;
  HapticDevice& operator=(const HapticDevice&) = delete;
  virtual ~HapticDevice() = default;

  /// Known before open() where the model is, exact after it.
  virtual const DeviceCapabilities& capabilities() const = 0;

  /// Throws DeviceError, with what to do about it, when the device isn't there. After a device was lost it
  /// may be called again.
  virtual void open() = 0;
  /// Leaves the device without force. Safe to call twice.
  virtual void close() noexcept = 0;

  /// The state at `time` [s] of the loop's clock, which never goes back. False: the device is lost, `state`
  /// is untouched.
  virtual bool read(double time, DeviceState& state) noexcept = 0;
  /// Held until the next write. False: the device is lost.
  virtual bool write(const DeviceForce& force) noexcept = 0;
};

}  // namespace pleura::haptics
