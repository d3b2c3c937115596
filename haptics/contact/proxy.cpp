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

bool isPlace(const Vector3d& p) {
  return std::all_of(p.begin(), p.end(),
                     [](double x) { return std::isfinite(x) && std::abs(x) <= kFarthest; });
}

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

/// The nearest magnetic surface that reaches the device. What is nearest to the device of the triangles that
/// are about the ball is so at every step anew, and each step brings it nearer.
Proxy::Pull Proxy::pullOn(const Vector3d& device, const Vector3d& drag) const {
  Pull none{-1, 0, device - drag};
  if (magneticDistance_ <= 0) return none;
  Pull pull = none;
  double least = std::numeric_limits<double>::max();
  for (int label = 0; label < space_.count(); ++label) {
    const ClearSpace::Plane& plane = space_.plane(label);
    if (surface(label).magneticDistance <= 0 || plane.gap >= least) continue;
    least = plane.gap;
    pull.label = label;
    pull.height = plane.normal.dot(device) - plane.offset;
  }
  if (pull.label < 0 || pull.height <= 0) return none;
  const double farthest = radius_ + surface(pull.label).magneticDistance;
  const Neighbourhood::Nearest at = near_.nearest(space_.shape(pull.label), pull.place, farthest);
  if (at.triangle < 0 || at.distance <= radius_) return none;
  pull.place = at.on.point + radius_ / at.distance * (pull.place - at.on.point);
  return pull;
}

const TouchSurface& Proxy::surface(int label) const { return space_.shape(label).now.surface; }

void Proxy::addContact(int label, double depth) {
  const ClearSpace::Plane& plane = space_.plane(label);
  const Neighbourhood::Shape& shape = space_.shape(label);
  contacts_[contactCount_++] = {
      shape.now.id, space_.meshTriangle(label), plane.on.weights, plane.on.point, plane.normal, shape.motion,
      depth,        shape.now.surface};
}

/// The contacts of the ball where it is; `free` is the projection of the pull's place.
void Proxy::rest(const Pull& pull, const HalfSpaceProjection& free) {
  contactCount_ = 0;
  bool held = pull.label >= 0 && space_.touches(pull.label);
  const Vector3d place = held ? Vector3d(device_ - pull.height * space_.plane(pull.label).normal) : device_;
  const auto isTouched = [this](const HalfSpaceProjection::Active& active) {
    return space_.touches(active.label);
  };
  const bool isThere = place == pull.place && std::ranges::all_of(free.active(), isTouched);
  const HalfSpaceProjection touched = isThere ? free : space_.alongTouched(place);
  for (const auto& [label, normal, depth] : touched.active()) {
    if (depth <= 0) continue;
    addContact(label, label == pull.label ? depth - pull.height : depth);
    if (label == pull.label) held = false;
  }
  if (held && contactCount_ < kMaxContacts) addContact(pull.label, -pull.height);
}

void Proxy::follow(std::span<const TouchShape> shapes, const Vector3d& asked) {
  const Vector3d device = isPlace(asked) ? asked : device_;
  const double least = std::max(radius_ / 16, 1.125 * (device - device_).norm());
  if (least > stride_ || least < stride_ / 8) stride_ = 1.1 * least;
  magneticDistance_ = 0;
  for (const TouchShape& shape : shapes) {
    assert(shape.s >= 0 && shape.s <= 1);
    magneticDistance_ = std::max(magneticDistance_, shape.surface.magneticDistance);
  }
  double stride = std::max(stride_, magneticDistance_);
  const double always = 4 * radius_ + magneticDistance_;
  device_ = device;
  near_.advance(shapes, position_);
  position_ = carried();
  Vector3d anchor = position_, drag = Vector3d::Zero();
  bool moved = false, isSpent = false;
  for (int steps = 0, leaps = 0;;) {
    const double reach = near_.gather(shapes, position_, radius_, always, radius_ + stride);
    space_.look(near_, position_, radius_, reach);
    const Pull held = pullOn(device, drag);
    const HalfSpaceProjection free = space_.nearestTo(held.place);
    const Vector3d wanted = stepTo(held, free, anchor, drag);
    const double length = (wanted - position_).norm();
    if (length < kStill || isSpent) {
      rest(held, free);
      break;
    }
    moved = true;
    isSpent = steps == kMaxSteps || leaps == kMaxLeaps;
    if (isSpent) {
      // what it went along bends away under it; a ball that touched something goes on to touch it
      if (!contacts().empty()) position_ = space_.nearestTouch(pullOn(device, drag).place);
    } else if (length > space_.range()) {
      position_ += space_.range() / length * (wanted - position_);
      stride = 2 * stride;
      ++leaps;
    } else {
      position_ = wanted;
      ++steps;
    }
    near_.moveTo(position_);
  }
  slides_ = moved && drag != Vector3d::Zero();
  near_.settle(position_, radius_);
}

/// Where friction and all that is near let the ball go from where it is.
Vector3d Proxy::stepTo(const Pull& pull, const HalfSpaceProjection& free, Vector3d& anchor,
                       Vector3d& drag) const {
  const auto isRough = [this](const HalfSpaceProjection::Active& active) {
    return surface(active.label).staticFriction > 0;
  };
  const bool holds = pull.label >= 0 && surface(pull.label).staticFriction > 0 && space_.touches(pull.label);
  if (drag != Vector3d::Zero() || (!holds && std::ranges::none_of(free.active(), isRough)))
    return free.point();

  const HalfSpaceProjection touching = space_.alongTouched(pull.place);
  double still = 0, sliding = 0;  // [m] that friction holds back: mu times depth
  const auto addFriction = [&](int label, double depth) {
    still += surface(label).staticFriction * depth;
    sliding += surface(label).dynamicFriction * depth;
  };
  for (const HalfSpaceProjection::Active& active : touching.active()) addFriction(active.label, active.depth);
  if (holds) addFriction(pull.label, pull.height);
  if (still > 0) {
    Vector3d held = space_.nearestTo(anchor).point();
    const Vector3d way = touching.point() - held;
    const double length = way.norm();
    if (length <= (slides_ ? sliding : still)) return held;
    drag = sliding / length * way;
    return space_.nearestTo(pull.place - drag).point();
  }
  double part = 1;  // of the way, until what has friction is met
  for (const HalfSpaceProjection::Active& active : free.active()) {
    const double closing = active.normal.dot(position_ - pull.place);
    const double gap = active.normal.dot(position_) - space_.plane(active.label).offset;
    if (closing > 0 && isRough(active)) part = std::min(part, std::max(0.0, gap) / closing);
  }
  anchor = space_.nearestTo(position_ + part * (pull.place - position_)).point();
  return anchor;
}

}  // namespace pleura::haptics
