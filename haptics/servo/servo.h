#pragma once

#include <array>
#include <optional>

#include <pleura/haptics/contact/proxy.h>
#include <pleura/haptics/device/haptic_device.h>
#include <pleura/haptics/servo/exchange.h>
#include <pleura/haptics/servo/force_guard.h>
#include <pleura/haptics/servo/servo_report.h>
#include <pleura/haptics/servo/touch_frame.h>

namespace pleura::haptics {

/// One haptic loop's work: the device is read, the scene's latest frame moved on to, the proxy follows, and
/// what is left of the force after all guards is written. tick() belongs to one thread, frames().back() and
/// reports() to the scene's; neither waits for the other, and tick() does not allocate.
class Servo {
 public:
  /// `period` [s] > 0 from one tick to the next. The device is open and outlives the servo.
  Servo(HapticDevice& device, double period);

  /// `time` [s] of the loop's clock, which never goes back; whether the tick comes so late that the deadline
  /// of another had passed.
  void tick(double time, bool hasMissedDeadline = false);

  Exchange<TouchFrame, 2>& frames() { return frames_; }
  Exchange<ServoReport, 1>& reports() { return reports_; }

  double period() const { return period_; }
  /// The most stiffness [N/m] and damping [N s/m] of a surface that this device renders stably at this
  /// period.
  double stiffnessLimit() const;
  double dampingLimit() const;

 private:
  struct Tracked {
    Eigen::Vector3d position, velocity;
    Eigen::Quaterniond orientation;
  };

  const TouchFrame& frame() const { return frames_.taken(0); }
  /// Moves on to the latest frame once the last one is reached.
  void takeFrame(double time);
  /// What there is to touch at this instant, in frame().instants.
  std::span<const TouchShape> instants(double s);
  /// No stiffer and no more damped than the device renders stably.
  TouchSurface stable(TouchSurface surface) const;
  Tracked trackedIn(const Workspace& workspace) const;
  ForceGuard::Rendered render(const Tracked& tracked, double time);
  Eigen::Vector3d effectForces(const Tracked& tracked, double time);
  void report(double time, const Tracked& tracked, const GuardedForce& given);

  HapticDevice& device_;
  double period_;
  DeviceState state_;
  std::optional<Proxy> proxy_;  // of the frame's radius
  ForceGuard guard_;
  bool wasConnected_ = false;
  double frameStart_ = 0;                                                // [s], when frame() was taken
  std::array<std::uint32_t, ServoReport::kMaxEffects> activeEffects_{};  // ids of springs that hold the tip
  std::array<Eigen::Vector3d, ServoReport::kMaxEffects> effectForces_;
  Exchange<TouchFrame, 2> frames_;
  Exchange<ServoReport, 1> reports_;
};

}  // namespace pleura::haptics
