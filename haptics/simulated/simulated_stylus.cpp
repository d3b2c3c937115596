#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include <pleura/haptics/safety/force_limiter.h>
#include <pleura/haptics/simulated/simulated_stylus.h>

namespace pleura::haptics {

namespace {

constexpr double kLongestStep = 1.0 / 16000;  // [s]
// A second's worth: a read that comes later than that takes longer steps, which stay stable, rather than
// long.
constexpr int kMostSteps = 16000;

}  // namespace

SimulatedStylus::SimulatedStylus(DeviceCapabilities capabilities, StylusPath path, StylusHand hand,
                                 double velocityCutoff)
    : capabilities_(std::move(capabilities)),
      path_(std::move(path)),
      hand_(hand),
      velocityCutoff_(velocityCutoff) {
  assert(velocityCutoff > 0);
  capabilities_.check();
  for (const double figure : {hand.stiffness, hand.damping})
    if (!(std::isfinite(figure) && figure >= 0 && figure <= 1e9))
      throw DeviceError(
          fmt::format("the hand of a simulated stylus: expected stiffness and damping of 0 or "
                      "more, found {}",
                      figure));
}

void SimulatedStylus::open() {
  if (!isPlugged_) throw DeviceError("the simulated stylus is unplugged: plug it in again");
  hasStarted_ = false;
  force_.setZero();
  isOpen_ = true;
}

void SimulatedStylus::close() noexcept {
  isOpen_ = false;
  force_.setZero();
}

void SimulatedStylus::unplug() noexcept {
  isPlugged_ = false;
  isOpen_ = false;
}

void SimulatedStylus::replug() noexcept { isPlugged_ = true; }

bool SimulatedStylus::read(double time, DeviceState& state) noexcept {
  if (!isOpen_) return false;
  assert(std::isfinite(time) && (!hasStarted_ || time >= time_));
  if (!hasStarted_) start(time);

  if (const double dt = time - time_; dt > 0) {
    const int steps = static_cast<int>(std::clamp(std::ceil(dt / kLongestStep), 1.0, double{kMostSteps}));
    const double h = dt / steps;
    Eigen::Vector3d handFrom = path_.position(time_);
    for (int i = 1; i <= steps; ++i) {
      const Eigen::Vector3d handTo = path_.position(time_ + i * h);
      step(handFrom, handTo, h);
      handFrom = handTo;
    }
    time_ = time;

    const Eigen::Vector3d told = encoded();
    const double share = -std::expm1(-2 * std::numbers::pi * velocityCutoff_ * dt);
    toldVelocity_ += share * ((told - told_) / dt - toldVelocity_);
    told_ = told;
  }
  state.position = told_;
  state.velocity = toldVelocity_;
  state.orientation = path_.orientation(time);
  state.buttons = path_.buttons(time);
  return true;
}

bool SimulatedStylus::write(const DeviceForce& force) noexcept {
  if (!isOpen_) return false;
  force_ = limited(force.force, capabilities_.maxForce);
  return true;
}

/// In the hand, moving with it.
void SimulatedStylus::start(double time) {
  hasStarted_ = true;
  time_ = time;
  work_ = {};
  position_ = path_.position(time);
  velocity_ = (path_.position(time + kLongestStep) - position_) / kLongestStep;
  stopAtWorkspace();
  work_ = {.lost = -0.5 * capabilities_.mass * velocity_.squaredNorm()};
  told_ = encoded();
  toldVelocity_.setZero();
}

// The implicit midpoint rule, with u the velocity at the middle of the step, (v + v1) / 2:
//   2 m (u - v) / h = F + k_h (x_h - x - u h/2) + c_h (x_h' - u) - b u - f_c u / |u|
// which is a u = r - f_c u / |u|, so u points along r, and is zero, the tip sticks, while |r| <= f_c. Second
// order while the tip slides, first where it begins to stick; stable for every h; its work adds up exactly.
void SimulatedStylus::step(const Eigen::Vector3d& handFrom, const Eigen::Vector3d& handTo, double h) {
  const auto& [k, c] = hand_;
  const double m = capabilities_.mass, b = capabilities_.damping, fc = capabilities_.friction;
  const Eigen::Vector3d hand = (handFrom + handTo) / 2, handVelocity = (handTo - handFrom) / h;

  const double a = 2 * m / h + k * h / 2 + c + b;
  const Eigen::Vector3d r = 2 * m / h * velocity_ + force_ + k * (hand - position_) + c * handVelocity;
  const double size = r.norm();
  const Eigen::Vector3d u = size > fc ? Eigen::Vector3d(r * ((1 - fc / size) / a)) : Eigen::Vector3d::Zero();

  const double kinetic = 0.5 * m * velocity_.squaredNorm();
  const Eigen::Vector3d handForce = k * (hand - position_ - u * (h / 2)) + c * (handVelocity - u);
  position_ += u * h;
  velocity_ = size > fc ? Eigen::Vector3d(2 * u - velocity_) : Eigen::Vector3d::Zero();
  const double motors = force_.dot(u) * h, byHand = handForce.dot(u) * h;
  work_.motors += motors;
  work_.hand += byHand;
  work_.lost += kinetic + motors + byHand - 0.5 * m * velocity_.squaredNorm();
  stopAtWorkspace();
}

void SimulatedStylus::stopAtWorkspace() {
  const double distance = position_.norm();
  if (distance <= capabilities_.workspaceRadius) return;
  const Eigen::Vector3d outwards = position_ / distance;
  position_ = outwards * capabilities_.workspaceRadius;
  const double speed = outwards.dot(velocity_);
  if (speed <= 0) return;
  velocity_ -= outwards * speed;
  work_.lost += 0.5 * capabilities_.mass * speed * speed;
}

Eigen::Vector3d SimulatedStylus::encoded() const {
  const double step = capabilities_.encoderStep;
  if (step == 0) return position_;
  return position_.unaryExpr([step](double x) { return std::round(x / step) * step; });
}

}  // namespace pleura::haptics
