#include <algorithm>
#include <cassert>
#include <cmath>

#include <pleura/haptics/contact/contact_force.h>
#include <pleura/haptics/safety/finite.h>
#include <pleura/haptics/safety/stiffness_limit.h>
#include <pleura/haptics/servo/servo.h>

namespace pleura::haptics {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

Isometry3d between(const Isometry3d& from, const Isometry3d& to, double s) {
  if (s >= 1 || from.isApprox(to, 0)) return to;
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = Quaterniond(from.linear()).slerp(s, Quaterniond(to.linear())).toRotationMatrix();
  pose.translation() = from.translation() + s * (to.translation() - from.translation());
  return pose;
}

/// The same shape in the frame before, most likely at the same place; null when it was not there.
const TouchFrameShape* sameShape(const TouchFrame& before, const TouchFrameShape& shape, std::size_t place) {
  const auto isSame = [&](const TouchFrameShape& other) {
    return other.id == shape.id && other.mesh == shape.mesh;
  };
  if (place < before.shapes.size() && isSame(before.shapes[place])) return &before.shapes[place];
  const auto found = std::find_if(before.shapes.begin(), before.shapes.end(), isSame);
  return found != before.shapes.end() ? &*found : nullptr;
}

/// How far [m] what is touched went since the last tick, each contact by its share of the depth.
Vector3d motionOf(std::span<const ProxyContact> contacts) {
  Vector3d sum = Vector3d::Zero();
  double depth = 0;
  for (const ProxyContact& contact : contacts) {
    sum += std::abs(contact.depth) * contact.motion;
    depth += std::abs(contact.depth);
  }
  return depth > 0 ? Vector3d(sum / depth) : sum;
}

}  // namespace

Servo::Servo(HapticDevice& device, double period)
    : device_(device),
      period_(period),
      proxy_(TouchFrame().tipRadius),
      guard_(device.capabilities(), period) {
  assert(period > 0);
}

double Servo::stiffnessLimit() const { return haptics::stiffnessLimit(device_.capabilities(), 0, period_); }

double Servo::dampingLimit() const {
  const DeviceCapabilities& device = device_.capabilities();
  return std::min(device.maxDamping, haptics::dampingLimit(device.damping, 0, period_));
}

void Servo::tick(double time, bool hasMissedDeadline) {
  DeviceState told;
  const bool isConnected = device_.read(time, told);
  const TickHealth health{.hasMissedDeadline = hasMissedDeadline, .isFinite = isFinite(told)};
  if (isConnected && health.isFinite) state_ = told;
  takeFrame(time);
  const TouchFrame& now = frame();
  const Tracked tracked = trackedIn(now.workspace);
  const bool isNew = !proxy_ || proxy_->radius() != now.tipRadius;
  if (isNew) proxy_.emplace(now.tipRadius);
  if (isNew || !isConnected || !wasConnected_) {
    proxy_->reset(tracked.position);
    guard_.restart();
  }
  wasConnected_ = isConnected;
  GuardedForce given;
  if (isConnected) {
    given = guard_.guard(render(tracked, time), state_, health);
    if (!device_.write({given.force, Vector3d::Zero()})) wasConnected_ = false;
  }
  if (!wasConnected_) guard_.noteLost();
  given.force = now.workspace.placement.linear() * given.force;
  report(time, tracked, given);
}

ForceGuard::Rendered Servo::render(const Tracked& tracked, double time) {
  const TouchFrame& now = frame();
  const double s = now.duration > 0 ? std::clamp((time - frameStart_) / now.duration, 0.0, 1.0) : 1.0;
  const auto shapes = instants(s);
  proxy_->follow(shapes, tracked.position);
  const Eigen::Matrix3d toDevice = now.workspace.placement.linear().transpose();
  const double scale = now.workspace.scale;
  ForceGuard::Rendered rendered{.carried = toDevice * motionOf(proxy_->contacts()) / scale,
                                .limit = now.forceLimit};
  const bool isAllowed = !now.deadmansSwitch || (state_.buttons & 1) != 0;
  const Vector3d effects = effectForces(tracked, time);
  if (!isAllowed) return rendered;
  // A surface's stiffness is that of the hand's metres: a workspace drawn large makes nothing harder.
  rendered.contact = toDevice * contactForce(*proxy_, tracked.position, tracked.velocity, period_) / scale;
  rendered.effects = toDevice * effects;
  return rendered;
}

void Servo::takeFrame(double time) {
  const double end = frameStart_ + frame().duration;
  constexpr double kRounding = 1e-9;
  if (time < end - kRounding || !frames_.take()) return;
  // On time: from where the last frame ended. Late: the shapes stood still meanwhile, and go on from here.
  frameStart_ = time - end < period_ + kRounding ? end : time - period_;
}

std::span<const TouchShape> Servo::instants(double s) {
  TouchFrame& now = frames_.taken(0);
  const TouchFrame& before = frames_.taken(1);
  for (std::size_t k = 0; k < now.shapes.size(); ++k) {
    const TouchFrameShape& to = now.shapes[k];
    const TouchFrameShape* from = sameShape(before, to, k);
    if (from == nullptr) from = &to;
    now.instants[k] = {.id = to.id,
                       .mesh = to.mesh.get(),
                       .from = from->stamp == to.stamp ? &to.points : &from->points,
                       .to = &to.points,
                       .s = static_cast<float>(s),
                       .pose = between(from->pose, to.pose, s),
                       .surface = stable(to.surface)};
  }
  return now.instants;
}

TouchSurface Servo::stable(TouchSurface surface) const {
  surface.stiffness = std::min(surface.stiffness, stiffnessLimit());
  surface.damping = std::min(
      surface.damping, haptics::dampingLimit(device_.capabilities().damping, surface.stiffness, period_));
  return surface;
}

Servo::Tracked Servo::trackedIn(const Workspace& workspace) const {
  const auto& placement = workspace.placement;
  return {.position = placement * (workspace.scale * state_.position),
          .velocity = placement.linear() * (workspace.scale * state_.velocity),
          .orientation = Quaterniond(placement.linear()) * state_.orientation};
}

Vector3d Servo::effectForces(const Tracked& tracked, double time) {
  const auto& effects = frame().effects;
  const double scale = frame().workspace.scale;
  Vector3d sum = Vector3d::Zero();
  std::array<std::uint32_t, ServoReport::kMaxEffects> active{};
  const std::size_t count = std::min<std::size_t>(effects.size(), ServoReport::kMaxEffects);
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t key = effects[k].id + 1;  // 0: no effect
    bool isActive = std::find(activeEffects_.begin(), activeEffects_.end(), key) != activeEffects_.end();
    effectForces_[k] = forceOf(atMost(effects[k], stiffnessLimit() / scale, dampingLimit() / scale),
                               tracked.position, tracked.velocity, time, isActive);
    active[k] = isActive ? key : 0;
    sum += effectForces_[k];
  }
  activeEffects_ = active;
  return sum;
}

void Servo::report(double time, const Tracked& tracked, const GuardedForce& given) {
  ServoReport& out = reports_.back();
  out.time = time;
  out.isConnected = wasConnected_;
  out.isStopped = given.isStopped;
  out.device = state_;
  out.trackerPosition = tracked.position;
  out.trackerOrientation = tracked.orientation;
  out.trackerVelocity = tracked.velocity;
  out.proxyPosition = proxy_->position();
  out.force = given.force;
  out.torque = Vector3d::Zero();
  out.contactCount = 0;
  for (const ProxyContact& contact : proxy_->contacts()) {
    auto& told = out.contacts[static_cast<std::size_t>(out.contactCount++)];
    told.shape = contact.shape;
    told.point = contact.point;
    told.normal = contact.normal;
    told.depth = contact.depth;
  }
  out.effectCount = static_cast<int>(std::min<std::size_t>(frame().effects.size(), ServoReport::kMaxEffects));
  for (std::size_t k = 0; k < static_cast<std::size_t>(out.effectCount); ++k) {
    out.effectForces[k] = effectForces_[k];
    out.isEffectActive[k] = activeEffects_[k] != 0;
  }
  reports_.publish();
}

}  // namespace pleura::haptics
