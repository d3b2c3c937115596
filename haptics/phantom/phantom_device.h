#pragma once

#include <atomic>
#include <optional>
#include <string>

#include <pleura/haptics/device/haptic_device.h>
#include <pleura/haptics/phantom/hd_api.h>
#include <pleura/haptics/phantom/latest_value.h>

namespace pleura::haptics {

/// A Phantom-class device (Touch, Omni, Desktop, Premium) through its vendor's HD library, which is looked
/// for when open() is called: nothing is needed to build.
///
/// HD's own scheduler talks to the device, in a callback each millisecond, and exchanges states and forces
/// with the haptic loop without locks. HD documents frames inside of its callbacks only, its safety checks
/// live there, hdBeginFrame blocks, and read() and write() may not. The price is delay, up to a period each
/// way, for which stiffnessLimit() has to be asked with a longer T: b > K (T/2 + t_d). The callback takes the
/// force away when the loop hasn't written for 20 of its ticks, and the loop takes the device for lost when a
/// tenth of a second has brought no new state.
///
/// The origin is the middle of the usable workspace, workspaceRadius its shortest half. Mass, damping and
/// friction are those of the preset that the device's model names, otherwise defaults. Torques are left out:
/// maxTorque is 0. One device a process, as HD has one scheduler.
///
/// Tested against a library of our own with the same symbols. What only hardware can show: that units and the
/// order of the transform are as documented, real delay and jitter, what HD reports when a cable is pulled,
/// and whether hdInitDevice then works again in the same process.
class PhantomDevice : public HapticDevice {
 public:
  /// `configuration`: the name that the vendor's setup gave the device; empty: its default device.
  explicit PhantomDevice(std::string configuration = {});
  ~PhantomDevice() override { close(); }

  /// Before open() those of a Touch.
  const DeviceCapabilities& capabilities() const override { return capabilities_; }
  void open() override;
  void close() noexcept override;
  bool read(double time, DeviceState& state) noexcept override;
  bool write(const DeviceForce& force) noexcept override;

 private:
  void start();
  void queryCapabilities();
  void throwOnError(const char* doing) const;
  bool exchange();
  static hd::CallbackCode exchangeOnce(void* self);
  static hd::CallbackCode exchangeEachTick(void* self);

  std::string configuration_;
  DeviceCapabilities capabilities_;
  std::optional<hd::Api> api_;
  hd::Handle device_ = hd::kInvalidHandle;
  std::optional<hd::ScheduledCallback> callback_;
  bool isHolder_ = false;                             // of the process' one scheduler
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();  // [mm]

  // What the two threads exchange.
  LatestValue<DeviceState> states_;
  LatestValue<Eigen::Vector3d> forces_;
  std::atomic<bool> isLost_ = true;

  // The scheduler's.
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();
  int ticksSinceForce_ = 0;
  hd::Name calibrationStyle_ = 0;

  // The loop's.
  DeviceState state_;
  std::optional<double> lastNews_;  // [s]
};

}  // namespace pleura::haptics
