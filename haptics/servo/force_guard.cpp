#include <algorithm>

#include <pleura/haptics/safety/finite.h>
#include <pleura/haptics/safety/force_limiter.h>
#include <pleura/haptics/servo/force_guard.h>

namespace pleura::haptics {

using Eigen::Vector3d;

namespace {

constexpr double kRiseTime = 0.05;  // [s]

}  // namespace

ForceGuard::ForceGuard(const DeviceCapabilities& device, double period)
    : device_(device), period_(period), rise_(kRiseTime) {}

void ForceGuard::restart() {
  rise_.restart();
  observer_.restart();
}

void ForceGuard::noteLost() {
  watchdog_.allows({.hasDevice = false}, period_);
  restart();
}

GuardedForce ForceGuard::guard(const Rendered& rendered, const DeviceState& state, const TickHealth& health) {
  TickHealth tick = health;
  tick.isFinite = health.isFinite && isFinite(rendered.contact) && isFinite(rendered.effects) &&
                  isFinite(rendered.carried);
  if (!watchdog_.allows(tick, period_)) {
    restart();
    return {.force = Vector3d::Zero(), .isStopped = true};
  }
  carried_ += rendered.carried;
  const Vector3d velocity = state.velocity - rendered.carried / period_;
  const double energy = observer_.observe(state.position - carried_);
  const bool isTouching = !rendered.contact.isZero(0) || !rendered.effects.isZero(0);
  const double gain = rise_.gain(isTouching, period_);
  // A quarter of what would stop the tip within a period: velocities from encoders lag behind.
  const double mostDamping = device_.mass / (4 * period_);
  const Vector3d contact = passivated(gain * rendered.contact, velocity, energy, period_, mostDamping);
  const double limit = rendered.limit >= 0 ? std::min(rendered.limit, device_.maxForce) : device_.maxForce;
  const Vector3d given = limited(contact + gain * rendered.effects, limit);
  observer_.hold(given - gain * rendered.effects);
  return {.force = given, .isStopped = false};
}

}  // namespace pleura::haptics
