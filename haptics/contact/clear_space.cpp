#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <pleura/haptics/contact/clear_space.h>

namespace pleura::haptics {

using Eigen::Vector3d;

namespace {

constexpr double kSlack = 1e-11;      // [m] by which a half-space may be missed
constexpr double kCover = 1e-9;       // [m] by which a triangle may stick out of another's half-space
constexpr double kOnSurface = 1e-12;  // [m] a nearer centre has no side
constexpr int kMaxAdditions = 24;     // of half-spaces to an intersection

}  // namespace

void ClearSpace::look(Neighbourhood& near, const Vector3d& position, double radius, double reach) {
  if (near_ == &near && seen_ == near.changes() && position == position_ && radius == radius_ &&
      range_ >= reach - radius)
    return;
  near_ = &near;
  seen_ = near.changes();
  position_ = position;
  radius_ = radius;
  range_ = reach - radius;
  count_ = waitingCount_ = 0;
  for (int k = 0; k < static_cast<int>(near.shapes().size()); ++k) {
    const Neighbourhood::Shape& shape = near.shapes()[k];
    screens_[k] = -1;
    if (!shape.felt) continue;
    Plane screen;
    if (shape.likely >= 0) {
      screen = planeOf(shape.likely);
      if (std::abs(screen.gap) <= kTouch && insert(screen)) screens_[k] = shape.likely;
    }
    const double farthest = reach + (shape.view - position).norm();
    near.visitWithin(shape, shape.view, farthest, [&](int index) {
      if (screens_[k] >= 0 && (index == screens_[k] || isBehind(index, screen))) return;
      if (isOff(index, shape.view, shape.view, radius + kTouch) && waitingCount_ < kMaxPlanes) {
        waiting_[waitingCount_++] = index;
        return;
      }
      const Plane plane = planeOf(index);
      if (plane.gap + radius <= farthest) insert(plane);
    });
  }
  for (int label = count_; label-- > 0;) near.expect(planes_[label].triangle);
}

ClearSpace::Plane ClearSpace::planeOf(int index) const {
  const Neighbourhood::Shape& shape = shapeOf(index);
  const TrianglePoint on = nearestOnTriangle(triangle(index).corners, shape.view);
  const Vector3d way = shape.view - on.point;
  const double distance = way.norm();
  const Vector3d normal = distance > kOnSurface
                              ? Vector3d(way / distance)
                              : outward(shape.now, triangle(index).index, on.weights).stableNormalized();
  return {normal, normal.dot(on.point) + radius_, distance - radius_, on, index};
}

/// Whether a plane that is drawn back by one radius has the triangle behind it.
bool ClearSpace::isBehind(int index, const Plane& plane) const {
  return (plane.normal.transpose() * triangle(index).corners).maxCoeff() <= plane.offset - radius_ + kCover;
}

/// Whether both ends of a way are so far off the triangle's own plane, on the same side.
bool ClearSpace::isOff(int index, const Vector3d& from, const Vector3d& to, double distance) const {
  const Corners& c = triangle(index).corners;
  const Vector3d normal = (c.col(1) - c.col(0)).cross(c.col(2) - c.col(0));
  const double needed = (distance - kCover) * normal.norm();
  const double before = normal.dot(from - c.col(0)), after = normal.dot(to - c.col(0));
  return needed > 0 && ((before >= needed && after >= needed) || (before <= -needed && after <= -needed));
}

/// Keeps the nearest first. False where there was no room; then the ball may go as far as the gap only.
bool ClearSpace::insert(const Plane& plane) {
  if (count_ == kMaxPlanes) {
    Plane& last = planes_[count_ - 1];
    range_ = std::min(range_, std::max({last.gap, plane.gap, 0.0}));
    if (plane.gap >= last.gap) return false;
    --count_;
  }
  int place = count_++;
  for (; place > 0 && planes_[place - 1].gap > plane.gap; --place) planes_[place] = planes_[place - 1];
  planes_[place] = plane;
  return true;
}

/// The way to the point is clear of a triangle if another's plane is between.
bool ClearSpace::covers(const Plane& plane, const Plane& other, const Vector3d& point, double shrink) const {
  return &plane != &other && triangle(plane.triangle).shape == triangle(other.triangle).shape &&
         plane.normal.dot(point) >= plane.offset - shrink - kSlack && plane.gap >= -shrink - kCover &&
         isBehind(other.triangle, plane);
}

bool ClearSpace::isCovered(int label, const HalfSpaceProjection& projection, double shrink) const {
  const Plane& plane = planes_[label];
  if (plane.triangle == screens_[triangle(plane.triangle).shape]) return false;
  const Vector3d& point = projection.point();
  if (covers(planes_[0], plane, point, shrink)) return true;
  for (const HalfSpaceProjection::Active& active : projection.active())
    if (covers(planes_[active.label], plane, point, shrink)) return true;
  return isOff(plane.triangle, shape(label).view, point, radius_ - shrink);
}

/// The first half-space that the point is outside of and nothing makes up for, or -1.
int ClearSpace::findViolated(const HalfSpaceProjection& projection, double farthest, double shrink) {
  const Vector3d& point = projection.point();
  const auto isViolated = [&](int label) {
    const Plane& plane = planes_[label];
    return plane.gap <= farthest && plane.normal.dot(point) < plane.offset - shrink - kSlack &&
           !isCovered(label, projection, shrink);
  };
  for (int label = 0; label < count_; ++label)
    if (isViolated(label)) return label;
  for (int k = 0; k < waitingCount_; ++k) {
    const int index = waiting_[k];
    if (isOff(index, shapeOf(index).view, point, radius_ - shrink)) continue;
    waiting_[k--] = waiting_[--waitingCount_];
    const Plane plane = planeOf(index);
    if (count_ == kMaxPlanes) {
      range_ = std::min(range_, std::max(plane.gap, 0.0));
      continue;
    }
    planes_[count_++] = plane;  // the labels of the others stay
    if (isViolated(count_ - 1)) return count_ - 1;
  }
  return -1;
}

/// False if the half-spaces have nothing in common.
bool ClearSpace::addAll(HalfSpaceProjection& projection, double farthest, double shrink) {
  for (int n = 0; n < kMaxAdditions; ++n) {
    const int label = findViolated(projection, farthest, shrink);
    if (label < 0) return true;
    if (!projection.add(label, planes_[label].normal, planes_[label].offset - shrink)) return false;
  }
  return true;
}

HalfSpaceProjection ClearSpace::project(const Vector3d& target, double farthest) {
  constexpr int kParts = 8;
  for (int part = 0; part <= kParts; ++part) {
    HalfSpaceProjection projection(target);
    if (addAll(projection, farthest, radius_ * part / kParts)) return projection;
  }
  return HalfSpaceProjection(position_);
}

}  // namespace pleura::haptics
