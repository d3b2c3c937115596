#pragma once

#include <atomic>

#include <pleura/haptics/device/haptic_device.h>
#include <pleura/haptics/simulated/stylus_path.h>

namespace pleura::haptics {

/// How a hand holds the tip: a spring and a damper to where it wants to be. Both 0: it has let go.
struct StylusHand {
  double stiffness = 200;  // [N/m] k_h >= 0; a relaxed to a firm grip: 100 to 1000
  double damping = 2;      // [N s/m] c_h >= 0
};

/// Work since open() [J], what a real device can't tell: motors + hand = lost + the tip's kinetic energy, to
/// rounding.
struct StylusWork {
  double motors =
      0;            // of the rendered force on the tip; positive over a stroke: the rendering feeds energy in
  double hand = 0;  // of the hand on the tip
  double lost = 0;  // in the mechanism's damping and friction, and at the stop of the workspace
};

/// A device made of a point mass in the hand of somebody who follows a path.
///
///   m x'' = F + k_h (x_h - x) + c_h (x_h' - x') - b x' - f_c x' / |x'|
///
/// m, b, f_c are the device's; F is the force written last, held until the next, at most maxForce. |x| <=
/// workspaceRadius is a stop without rebound. What is told: the position in whole encoder steps on each axis;
/// a velocity from differences of what is told, through a first-order low-pass, as drivers do. The
/// orientation is the hand's: torques move nothing. A force written after read(t) acts from t on: there is no
/// delay but the hold. The same calls give the same bits.
class SimulatedStylus : public HapticDevice {
 public:
  /// Throws DeviceError on impossible capabilities and a hand that is not finite or negative.
  /// velocityCutoff [Hz] > 0 of the low-pass.
  SimulatedStylus(DeviceCapabilities capabilities, StylusPath path, StylusHand hand,
                  double velocityCutoff = 100);

  const DeviceCapabilities& capabilities() const override { return capabilities_; }
  void open() override;
  void close() noexcept override;
  bool read(double time, DeviceState& state) noexcept override;
  bool write(const DeviceForce& force) noexcept override;

  /// The cable is pulled out, from any thread: read() and write() fail until open(), which fails until
  /// replug().
  void unplug() noexcept;
  void replug() noexcept;

  /// Where the tip is [m], how fast [m/s], and the work done since open(), as of the last read(): the truth,
  /// before encoders.
  const Eigen::Vector3d& position() const { return position_; }
  const Eigen::Vector3d& velocity() const { return velocity_; }
  const StylusWork& work() const { return work_; }

 private:
  void start(double time);
  void step(const Eigen::Vector3d& handFrom, const Eigen::Vector3d& handTo, double h);
  void stopAtWorkspace();
  Eigen::Vector3d encoded() const;

  DeviceCapabilities capabilities_;
  StylusPath path_;
  StylusHand hand_;
  double velocityCutoff_;
  std::atomic<bool> isPlugged_ = true;
  std::atomic<bool> isOpen_ = false;

  bool hasStarted_ = false;
  double time_ = 0;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d told_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d toldVelocity_ = Eigen::Vector3d::Zero();
  StylusWork work_;
};

}  // namespace pleura::haptics
