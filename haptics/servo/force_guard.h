#pragma once

#include <pleura/haptics/device/haptic_device.h>
#include <pleura/haptics/safety/force_rise.h>
#include <pleura/haptics/safety/passivity.h>
#include <pleura/haptics/safety/watchdog.h>

namespace pleura::haptics {

/// What the hand is given, in the device's frame, and whether the watchdog holds it at zero.
struct GuardedForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // [N]
  bool isStopped = false;
};

/// All that stands between a rendered force and a hand: rise at first contact, passivity, the limit, the
/// watchdog. On by default and never off. Does not allocate.
class ForceGuard {
 public:
  /// `period` [s] > 0 of the loop.
  ForceGuard(const DeviceCapabilities& device, double period);

  /// The device was opened, or is about to be given force again.
  void restart();

  /// A force rendered in a tick, in the device's frame.
  struct Rendered {
    Eigen::Vector3d contact =
        Eigen::Vector3d::Zero();  // [N] of surfaces, which give back no more than they take
    Eigen::Vector3d effects = Eigen::Vector3d::Zero();  // [N] that may do work on the hand
    Eigen::Vector3d carried =
        Eigen::Vector3d::Zero();  // [m] that surfaces moved what touches them since the last
                                  // tick: work that the scene does, not the rendering
    double limit = -1;            // [N]; negative: the device's own, which holds in any case
  };
  /// `state` is finite: the last good one where the device told no numbers, which `health` says.
  GuardedForce guard(const Rendered& rendered, const DeviceState& state, const TickHealth& health);

  /// The device did not answer in this tick.
  void noteLost();

 private:
  DeviceCapabilities device_;
  double period_;
  ForceRise rise_;
  PassivityObserver observer_;
  Watchdog watchdog_;
  Eigen::Vector3d carried_ = Eigen::Vector3d::Zero();  // sum of all
};

}  // namespace pleura::haptics
