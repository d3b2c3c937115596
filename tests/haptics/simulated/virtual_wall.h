#pragma once

#include <algorithm>
#include <cmath>

#include <pleura/haptics/safety/passivity.h>
#include <pleura/haptics/simulated/simulated_stylus.h>

namespace pleura::haptics {

/// A wall at x = 0 on a simulated stylus, solid where x < 0: F = -K x on what encoders tell, held a period.
struct VirtualWall {
  double stiffness = 0;   // K [N/m]
  double period = 0.001;  // T [s]
  double damping = 0.2;   // b [N s/m]
  double friction = 0;    // f_c [N]
  double encoderStep = 0;
  double handStiffness = 0;       // k_h [N/m]
  double handDamping = 0;         // c_h [N s/m]
  bool isTwoSided = false;        // a spring to x = 0 rather than a wall
  double controllerDamping = -1;  // [N s/m] a_max of a passivity controller; none if negative

  static constexpr double kMass = 0.045;

  SimulatedStylus stylus(StylusPath path) const {
    return {{.model = "wall's",
             .maxForce = 1e6,
             .maxStiffness = 1e6,
             .workspaceRadius = 0.1,
             .mass = kMass,
             .damping = damping,
             .friction = friction,
             .encoderStep = encoderStep},
            std::move(path),
            {.stiffness = handStiffness, .damping = handDamping}};
  }

  /// At rest at `from`, then drawn by a hand at `to`.
  SimulatedStylus released(double from, double to) const {
    return stylus(StylusPath(
        {{.time = period / 4, .position = {from, 0, 0}}, {.time = period / 2, .position = {to, 0, 0}}}));
  }

  /// Renders ticks 0, 1, .. while keepOn(tick, told position).
  template <class KeepOn>
  void render(SimulatedStylus& on, KeepOn&& keepOn) const {
    PassivityObserver observer;
    DeviceState state;
    on.open();
    for (int tick = 0; on.read(tick * period, state) && keepOn(tick, state.position.x()); ++tick) {
      const double x = state.position.x();
      Eigen::Vector3d force(isTwoSided || x < 0 ? -stiffness * x : 0, 0, 0);
      const double energy = observer.observe(state.position);
      if (controllerDamping >= 0)
        force = passivated(force, state.velocity, energy, period, controllerDamping);
      observer.hold(force);
      on.write({.force = force});
    }
  }

  /// How far from rest the tip swings at most in the last second of ten, when a hand holds it 2 mm deep and
  /// it begins 1 mm from there.
  double swing() const {
    constexpr double kDepth = 0.002, kSeconds = 10;
    auto tip = released(-kDepth / 2, -kDepth * (stiffness + handStiffness) / handStiffness);
    double most = 0;
    render(tip, [&](int tick, double) {
      if (tick * period > kSeconds - 1) most = std::max(most, std::abs(tip.position().x() + kDepth));
      return tick * period < kSeconds;
    });
    return most;
  }
};

/// Where `isStable(K)` turns false, between `low`, where it is true, and `high`, to a thousandth of `high`.
template <class IsStable>
double measuredLimit(double low, double high, IsStable&& isStable) {
  for (const double precision = high / 1000; high - low > precision;) {
    const double middle = (low + high) / 2;
    (isStable(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace pleura::haptics
