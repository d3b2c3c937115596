#pragma once

#include <bit>
#include <cassert>
#include <cstdint>

namespace pleura::haptics {

/// When a device must be left without force, and how long.
struct WatchdogRules {
  int window = 50;      // M: the deadlines that are looked back on, 1 to 64
  int mostMissed = 10;  // N: force goes when more than N of the last M were missed
  double quietTime =
      0.5;  // [s] without a fault, and no more than N of the last M missed, until it may return
};

/// What a haptic loop knows of a tick.
struct TickHealth {
  bool hasMissedDeadline = false;
  bool isFinite = true;   // state and force were numbers
  bool hasDevice = true;  // read() and write() succeeded
};

/// Decides whether a device may get force. A NaN or a lost device takes it at once, missed deadlines when
/// more than N of the last M are. It comes back after a quiet time; whoever lets it come back goes through
/// ForceRise.
class Watchdog {
 public:
  enum class Fault { none, deadlines, notFinite, deviceLost };

  explicit Watchdog(const WatchdogRules& rules = {}) : rules_(rules) {
    assert(rules.window >= 1 && rules.window <= 64 && rules.mostMissed >= 0 && rules.quietTime >= 0);
  }

  /// One tick, dt [s] >= 0 after the last one; whether its force may be written.
  bool allows(const TickHealth& tick, double dt) {
    const std::uint64_t mask =
        rules_.window == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << rules_.window) - 1;
    missed_ = (missed_ << 1 | (tick.hasMissedDeadline ? 1u : 0u)) & mask;
    const Fault now = !tick.hasDevice                              ? Fault::deviceLost
                      : !tick.isFinite                             ? Fault::notFinite
                      : std::popcount(missed_) > rules_.mostMissed ? Fault::deadlines
                                                                   : Fault::none;
    if (now != Fault::none) {
      fault_ = now;
      quiet_ = 0;
    } else if (fault_ != Fault::none && (quiet_ += dt) >= rules_.quietTime) {
      fault_ = Fault::none;
    }
    return fault_ == Fault::none;
  }

  /// Why there is no force.
  Fault fault() const { return fault_; }

 private:
  WatchdogRules rules_;
  std::uint64_t missed_ = 0;  // bit k: the deadline k ticks ago
  Fault fault_ = Fault::none;
  double quiet_ = 0;
};

}  // namespace pleura::haptics
