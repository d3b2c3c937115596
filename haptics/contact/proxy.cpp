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

constexpr double kFarthest = 1e6;     // [m] that a device may be away
constexpr double kStill = 1e-8;       // [m] a shorter step is none
constexpr double kTouch = 1e-6;       // [m] a smaller gap is contact
constexpr double kSlack = 1e-11;      // [m] by which a half-space may be missed
constexpr double kCover = 1e-9;       // [m] by which a triangle may stick out of another's half-space
constexpr double kOnSurface = 1e-12;  // [m] a nearer centre has no side
constexpr double kEverywhere = std::numeric_limits<double>::max();
constexpr int kMaxSteps = 12;      // until it is nearest to the device
constexpr int kMaxLeaps = 48;      // of a device that jumped, on top of these
constexpr int kMaxAdditions = 24;  // of half-spaces to an intersection

bool isPlace(const Vector3d& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() <= kFarthest; }

}  // namespace

/// The half-spaces about the ball, nearest first.
struct Proxy::Planes {
  static constexpr int kMax = 64;

  /// Those that a ball at `position` may meet before it has gone reach - radius. A touched triangle's plane,
  /// the guess (an index, or -1), saves those behind it.
  Planes(const Neighbourhood& near, const Vector3d& position, double ballRadius, double reach, int guess);

  /// The point nearest to the target in the half-spaces of triangles that are at most so far from the ball. A
  /// ball that is squeezed gives way.
  HalfSpaceProjection project(const Vector3d& target, double farthest) const;

  const Plane& operator[](int label) const { return planes[label]; }

  const TouchSurface& surface(int label) const { return shapes[planes[label].triangle->shape].now.surface; }

  double radius;
  Vector3d centre;
  double clear;  // [m] that the centre may go without meeting what isn't here
  std::array<Plane, kMax> planes;
  int count = 0;
  const Neighbourhood::Triangle* screening = nullptr;  // the others behind its plane aren't here
  std::span<const Neighbourhood::Shape> shapes;

 private:
  Plane planeOf(const Neighbourhood::Triangle& triangle) const;
  bool isBehind(const Neighbourhood::Triangle& triangle, const Plane& plane) const;
  void insert(const Plane& plane);
  bool add(HalfSpaceProjection& projection, double farthest, double shrink) const;
  bool covers(const Plane& plane, const Plane& other, const Vector3d& point, double shrink) const;
  bool covered(const Plane& plane, const HalfSpaceProjection& projection, double shrink) const;
};

Proxy::Planes::Planes(const Neighbourhood& near, const Vector3d& position, double ballRadius, double reach,
                      int guess)
    : radius(ballRadius), centre(position), clear(reach - ballRadius), shapes(near.shapes()) {
  const std::span<const Neighbourhood::Triangle> triangles = near.triangles();
  Plane screen;
  if (guess >= 0 && guess < static_cast<int>(triangles.size()) && shapes[triangles[guess].shape].felt) {
    screen = planeOf(triangles[guess]);
    if (std::abs(screen.gap) <= kTouch) {
      screening = screen.triangle;
      insert(screen);
    }
  }
  for (const Neighbourhood::Shape& shape : shapes) {
    if (!shape.felt) continue;
    const double farthest = reach + (shape.view - position).norm();
    near.visitWithin(shape, shape.view, farthest, [&](int index) {
      const Neighbourhood::Triangle& triangle = triangles[index];
      if (&triangle == screening || (screening && isBehind(triangle, screen))) return;
      const Plane plane = planeOf(triangle);
      if (plane.gap + radius <= farthest) insert(plane);
    });
  }
}

Proxy::Plane Proxy::Planes::planeOf(const Neighbourhood::Triangle& triangle) const {
  const Neighbourhood::Shape& shape = shapes[triangle.shape];
  const TrianglePoint on = nearestOnTriangle(triangle.corners, shape.view);
  const Vector3d way = shape.view - on.point;
  const double distance = way.norm();
  const Vector3d normal = distance > kOnSurface
                              ? Vector3d(way / distance)
                              : outward(shape.now, triangle.index, on.weights).stableNormalized();
  return {normal, normal.dot(on.point) + radius, distance - radius, on, &triangle};
}

/// Whether a plane that is drawn back by one radius has the triangle behind it.
bool Proxy::Planes::isBehind(const Neighbourhood::Triangle& triangle, const Plane& plane) const {
  return triangle.shape == plane.triangle->shape &&
         (plane.normal.transpose() * triangle.corners).maxCoeff() <= plane.offset - radius + kCover;
}

void Proxy::Planes::insert(const Plane& plane) {
  if (count == kMax) {
    const double dropped = std::max(planes[count - 1].gap, plane.gap);
    clear = std::min(clear, std::max(dropped, 0.0));
    if (plane.gap >= planes[count - 1].gap) return;
    --count;
  }
  int place = count++;
  for (; place > 0 && planes[place - 1].gap > plane.gap; --place) planes[place] = planes[place - 1];
  planes[place] = plane;
}

/// The way to the point is clear of a triangle too if another's plane is between.
bool Proxy::Planes::covers(const Plane& plane, const Plane& other, const Vector3d& point,
                           double shrink) const {
  return &plane != &other && plane.normal.dot(point) >= plane.offset - shrink - kSlack &&
         plane.gap >= -shrink - kSlack && isBehind(*other.triangle, plane);
}

bool Proxy::Planes::covered(const Plane& plane, const HalfSpaceProjection& projection, double shrink) const {
  if (plane.triangle == screening) return false;
  const Vector3d& point = projection.point();
  if (covers(planes[0], plane, point, shrink)) return true;
  for (const HalfSpaceProjection::Active& active : projection.active())
    if (covers(planes[active.label], plane, point, shrink)) return true;
  // the triangle's own plane
  const Corners& c = plane.triangle->corners;
  const Vector3d normal = (c.col(1) - c.col(0)).cross(c.col(2) - c.col(0));
  const double needed = (radius - shrink - kCover) * normal.norm();
  const double before = normal.dot(shapes[plane.triangle->shape].view - c.col(0)),
               after = normal.dot(point - c.col(0));
  return (before >= needed && after >= needed) || (before <= -needed && after <= -needed);
}

/// False if the half-spaces have nothing in common.
bool Proxy::Planes::add(HalfSpaceProjection& projection, double farthest, double shrink) const {
  for (int n = 0; n < kMaxAdditions; ++n) {
    int label = 0;
    for (; label < count && planes[label].gap <= farthest; ++label) {
      const Plane& plane = planes[label];
      if (plane.normal.dot(projection.point()) < plane.offset - shrink - kSlack &&
          !covered(plane, projection, shrink))
        break;
    }
    if (label == count || planes[label].gap > farthest) return true;
    if (!projection.add(label, planes[label].normal, planes[label].offset - shrink)) return false;
  }
  return true;
}

HalfSpaceProjection Proxy::Planes::project(const Vector3d& target, double farthest) const {
  constexpr int kParts = 8;
  for (int part = 0; part <= kParts; ++part) {
    HalfSpaceProjection projection(target);
    if (add(projection, farthest, radius * part / kParts)) return projection;
  }
  return HalfSpaceProjection(centre);
}

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

void Proxy::rest(const Planes& planes, const HalfSpaceProjection& touching) {
  contactCount_ = 0;
  const auto add = [&](int label, double depth) {
    const Plane& plane = planes[label];
    const Neighbourhood::Shape& shape = planes.shapes[plane.triangle->shape];
    contacts_[contactCount_++] = {shape.now.id,   plane.triangle->index, plane.on.weights,
                                  plane.on.point, plane.normal,          shape.motion,
                                  depth,          shape.now.surface};
  };
  for (const HalfSpaceProjection::Active& active : touching.active())
    if (active.depth > 0) add(active.label, active.depth);
}

void Proxy::follow(std::span<const TouchShape> shapes, const Vector3d& asked) {
  const Vector3d device = isPlace(asked) ? asked : device_;
  double stride = std::max(radius_ / 16, 1.25 * (device - device_).norm());
  for (const TouchShape& shape : shapes) {
    assert(shape.s >= 0 && shape.s <= 1);
    stride = std::max(stride, shape.surface.magneticDistance);
  }
  device_ = device;
  near_.advance(shapes, position_);
  position_ = carried();
  Vector3d anchor = position_;
  bool slips = slides_, moved = false;
  for (int steps = 0, leaps = 0;;) {
    const double reach = near_.gather(shapes, position_, radius_, radius_ + stride);
    const Planes planes(near_, position_, radius_, reach, guess_);
    guess_ = planes.count > 0 ? static_cast<int>(planes[0].triangle - near_.triangles().data()) : -1;
    const HalfSpaceProjection touching = planes.project(device, kTouch);
    const Vector3d wanted = stepFrom(planes, touching, device, anchor, slips);
    const double length = (wanted - position_).norm();
    if (length < kStill || steps == kMaxSteps || leaps == kMaxLeaps) {
      rest(planes, touching);
      break;
    }
    moved = true;
    if (length > planes.clear) {
      position_ += planes.clear / length * (wanted - position_);
      stride = 2 * stride;
      ++leaps;
    } else {
      position_ = wanted;
      ++steps;
    }
    near_.moveTo(position_);
  }
  slides_ = slips && moved;
  near_.settle(position_, radius_);
}

/// Where friction and all that is near let the ball go from where it is.
Vector3d Proxy::stepFrom(const Planes& planes, const HalfSpaceProjection& touching, const Vector3d& target,
                         Vector3d& anchor, bool& slips) const {
  double still = 0, sliding = 0;  // [m] that friction holds back: mu times depth
  for (const HalfSpaceProjection::Active& active : touching.active()) {
    still += planes.surface(active.label).staticFriction * active.depth;
    sliding += planes.surface(active.label).dynamicFriction * active.depth;
  }
  if (still > 0) {
    const Vector3d held = planes.project(anchor, kEverywhere).point();
    const Vector3d way = touching.point() - held;
    const double length = way.norm();
    if (length <= (slips ? sliding : still)) return held;
    slips = true;
    return planes.project(held + (1 - sliding / length) * way, kEverywhere).point();
  }
  const HalfSpaceProjection free = planes.project(target, kEverywhere);
  double part = 1;  // of the way, until something that has friction is met
  for (const HalfSpaceProjection::Active& active : free.active()) {
    if (planes.surface(active.label).staticFriction <= 0) continue;
    const double closing = active.normal.dot(position_ - target);
    if (closing > 0)
      part =
          std::min(part, std::max(0.0, active.normal.dot(position_) - planes[active.label].offset) / closing);
  }
  if (part == 1) return free.point();
  anchor = planes.project(position_ + part * (target - position_), kEverywhere).point();
  return anchor;
}

}  // namespace pleura::haptics
