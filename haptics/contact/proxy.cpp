#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <pleura/haptics/contact/half_space_projection.h>
#include <pleura/haptics/contact/proxy.h>

namespace pleura::haptics {

using Eigen::Vector3d;

namespace {

constexpr double kFarthest = 1e6;  // [m] that a device may be away
constexpr double kStill = 1e-8;    // [m] a shorter step is none
constexpr int kMaxSteps = 12;      // until it is nearest to the device
constexpr int kMaxLeaps = 48;      // of a device that jumped, on top of these

bool isPlace(const Vector3d& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() <= kFarthest; }

}  // namespace

Proxy::Proxy(double radius) : radius_(radius) { assert(radius > 0); }

void Proxy::reset(const Vector3d& position) {
  assert(isPlace(position));
  position_ = device_ = position;
  near_.clear();
  contactCount_ = 0;
  slides_ = false;
}

/// Where the ball is if it stays where it rested.
Vector3d Proxy::carried() const {
  Vector3d sum = Vector3d::Zero();
  double weights = 0;
  for (const ProxyContact& contact : contacts()) {
    const auto shape =
        std::ranges::find(near_.shapes(), contact.shape, [](const auto& s) { return s.now.id; });
    if (shape == near_.shapes().end()) continue;
    sum += std::abs(contact.depth) * (shape->view - position_);
    weights += std::abs(contact.depth);
  }
  return weights > 0 ? Vector3d(position_ + sum / weights) : position_;
}

void Proxy::rest() {
  contactCount_ = 0;
  const HalfSpaceProjection touching = space_.alongTouched(device_);
  for (const HalfSpaceProjection::Active& active : touching.active()) {
    if (active.depth <= 0) continue;
    const ClearSpace::Plane& plane = space_.plane(active.label);
    const Neighbourhood::Shape& shape = space_.shape(active.label);
    contacts_[contactCount_++] = {shape.now.id,     space_.meshTriangle(active.label),
                                  plane.on.weights, plane.on.point,
                                  plane.normal,     shape.motion,
                                  active.depth,     shape.now.surface};
  }
}

void Proxy::follow(std::span<const TouchShape> shapes, const Vector3d& asked) {
  const Vector3d device = isPlace(asked) ? asked : device_;
  const double least = std::max(radius_ / 16, 1.125 * (device - device_).norm());
  if (least > stride_ || least < stride_ / 8) stride_ = 1.1 * least;
  double stride = stride_;
  for (const TouchShape& shape : shapes) {
    assert(shape.s >= 0 && shape.s <= 1);
    stride = std::max(stride, shape.surface.magneticDistance);
  }
  device_ = device;
  near_.advance(shapes, position_);
  position_ = carried();
  Vector3d anchor = position_, goal = device;
  bool drags = false, moved = false;
  for (int steps = 0, leaps = 0;;) {
    const double reach = near_.gather(shapes, position_, radius_, radius_ + stride);
    space_.look(near_, position_, radius_, reach);
    const Vector3d wanted = stepTo(goal, anchor, drags);
    const double length = (wanted - position_).norm();
    if (length < kStill || steps == kMaxSteps || leaps == kMaxLeaps) {
      rest();
      break;
    }
    moved = true;
    if (length > space_.range()) {
      position_ += space_.range() / length * (wanted - position_);
      stride = 2 * stride;
      ++leaps;
    } else {
      position_ = wanted;
      ++steps;
    }
    near_.moveTo(position_);
  }
  slides_ = drags && moved;
  near_.settle(position_, radius_);
}

/// Where friction and all that is near let the ball go from where it is.
Vector3d Proxy::stepTo(Vector3d& goal, Vector3d& anchor, bool& drags) {
  const HalfSpaceProjection free = space_.nearestTo(goal);
  const auto isRough = [this](const HalfSpaceProjection::Active& active) {
    return space_.shape(active.label).now.surface.staticFriction > 0;
  };
  if (drags || std::ranges::none_of(free.active(), isRough)) return free.point();
  const HalfSpaceProjection touching = space_.alongTouched(goal);
  double still = 0, sliding = 0;  // [m] that friction holds back: mu times depth
  for (const HalfSpaceProjection::Active& active : touching.active()) {
    const TouchSurface& surface = space_.shape(active.label).now.surface;
    still += surface.staticFriction * active.depth;
    sliding += surface.dynamicFriction * active.depth;
  }
  if (still > 0) {
    const Vector3d held = space_.nearestTo(anchor).point();
    const Vector3d way = touching.point() - held;
    const double length = way.norm();
    if (length <= (slides_ ? sliding : still)) return held;
    drags = true;
    goal -= sliding / length * way;
    return space_.nearestTo(goal).point();
  }
  double part = 1;  // of the way, until what has friction is met
  for (const HalfSpaceProjection::Active& active : free.active()) {
    const double closing = active.normal.dot(position_ - goal);
    const double gap = active.normal.dot(position_) - space_.plane(active.label).offset;
    if (closing > 0 && isRough(active)) part = std::min(part, std::max(0.0, gap) / closing);
  }
  anchor = space_.nearestTo(position_ + part * (goal - position_)).point();
  return anchor;
}

}  // namespace pleura::haptics
