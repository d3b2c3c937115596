#pragma once

#include <algorithm>
#include <cassert>

namespace pleura::haptics {

/// A gain that keeps a device from jumping when its force is switched on while the tip is inside of
/// something:
///   g = min(1, t / t_r),  t since the first contact after restart()
/// 0 until then.
class ForceRise {
 public:
  /// riseTime t_r [s] > 0.
  explicit ForceRise(double riseTime) : riseTime_(riseTime) { assert(riseTime > 0); }

  /// Force was switched off, or is about to be switched on.
  void restart() { elapsed_ = 0, hasTouched_ = false; }

  /// The gain of this tick, dt [s] >= 0 after the last one.
  double gain(bool isTouching, double dt) {
    if (hasTouched_) elapsed_ = std::min(riseTime_, elapsed_ + dt);
    hasTouched_ = hasTouched_ || isTouching;
    return elapsed_ / riseTime_;
  }

 private:
  double riseTime_;
  double elapsed_ = 0;
  bool hasTouched_ = false;
};

}  // namespace pleura::haptics
