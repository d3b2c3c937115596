#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <pleura/haptics/contact/clear_space.h>

namespace pleura::haptics {

using Eigen::Vector3d;

namespace {

constexpr double kSlack = 1e-11;      // [m] by which a half-space may be missed
constexpr double kCover = 2e-9;       // [m] by which a triangle may stick out of another's half-space
constexpr double kOnSurface = 1e-12;  // [m] a nearer centre has no side
constexpr int kMaxAdditions = 24;     // of half-spaces to an intersection
constexpr int kMaxShrinks = 20;       // of the size of a ball that is squeezed

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
  count_ = 0;
  nearest_ = -1;
  for (int k = 0; k < static_cast<int>(near.shapes().size()); ++k) {
    const Neighbourhood::Shape& shape = near.shapes()[k];
    screens_[k] = -1;
    if (!shape.felt) continue;
    const double farthest = reach + (shape.view - position).norm();
    Plane screen, plane;
    if (shape.likely >= 0 && makePlane(shape, shape.likely, radius_ + kTouch, screen) &&
        screen.gap >= -kTouch && keep(screen))
      screens_[k] = shape.likely;
    const auto add = [&](int index) {
      if (makePlane(shape, index, farthest, plane)) keep(plane);
    };
    if (screens_[k] < 0)
      near.visitWithin(shape, shape.view, farthest, add);
    else
      near.visitInFront(shape, shape.view, farthest, screen.normal, screen.offset - radius_ + kCover,
                        [&](int index) {
                          if (index != screens_[k] && !isBehind(index, screen)) add(index);
                        });
  }
  tellNearest(near);
}

/// What is nearest now will do to start from the next time.
void ClearSpace::tellNearest(Neighbourhood& near) {
  std::array<double, Neighbourhood::kMaxShapes> least;
  std::fill_n(least.begin(), near.shapes().size(), std::numeric_limits<double>::max());
  for (int label = 0; label < count_; ++label) {
    const Plane& plane = planes_[label];
    double& gap = least[triangle(plane.triangle).shape];
    if (plane.gap >= gap) continue;
    gap = plane.gap;
    near.expect(plane.triangle);
    if (nearest_ < 0 || gap < planes_[nearest_].gap) nearest_ = label;
  }
}

/// The plane through the triangle's point nearest to the ball; false if that is beyond `farthest` [m].
bool ClearSpace::makePlane(const Neighbourhood::Shape& shape, int index, double farthest,
                           Plane& plane) const {
  plane.on = nearestOnTriangle(triangle(index).corners, shape.view);
  const Vector3d way = shape.view - plane.on.point;
  const double squared = way.squaredNorm();
  if (squared > farthest * farthest) return false;
  const double distance = std::sqrt(squared);
  if (distance > kOnSurface)
    plane.normal = way / distance;
  else
    plane.normal = outward(shape.now, triangle(index).index, plane.on.weights).normalized();
  plane.offset = plane.normal.dot(plane.on.point) + radius_;
  plane.gap = distance - radius_;
  plane.triangle = index;
  return true;
}

/// Whether a plane that is drawn back by one radius has the triangle behind it.
bool ClearSpace::isBehind(int index, const Plane& plane) const {
  return (plane.normal.transpose() * triangle(index).corners).maxCoeff() <= plane.offset - radius_ + kCover;
}

/// False where there is no room; the ball may go no farther than to what was left out.
bool ClearSpace::keep(const Plane& plane) {
  if (count_ < kMaxPlanes) {
    planes_[count_++] = plane;
    return true;
  }
  const auto farthest = std::ranges::max_element(planes_, {}, &Plane::gap);
  range_ = std::min(range_, std::max({farthest->gap, plane.gap, 0.0}));
  if (plane.gap >= farthest->gap) return false;
  *farthest = plane;
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
  if (covers(planes_[nearest_], plane, point, shrink)) return true;
  for (const HalfSpaceProjection::Active& active : projection.active())
    if (covers(planes_[active.label], plane, point, shrink)) return true;
  // the triangle's own plane
  const Corners& c = triangle(plane.triangle).corners;
  const Vector3d normal = (c.col(1) - c.col(0)).cross(c.col(2) - c.col(0));
  const double needed = (radius_ - shrink - kCover) * normal.norm();
  const double before = normal.dot(shape(label).view - c.col(0)), after = normal.dot(point - c.col(0));
  return needed > 0 && ((before >= needed && after >= needed) || (before <= -needed && after <= -needed));
}

/// The nearest half-space that the point is outside of and nothing makes up for, or -1.
int ClearSpace::findViolated(const HalfSpaceProjection& projection, double farthest, double shrink) const {
  int nearest = -1;
  for (int label = 0; label < count_; ++label) {
    const Plane& plane = planes_[label];
    if (plane.gap > farthest || (nearest >= 0 && plane.gap >= planes_[nearest].gap)) continue;
    if (plane.normal.dot(projection.point()) >= plane.offset - shrink - kSlack) continue;
    if (!isCovered(label, projection, shrink)) nearest = label;
  }
  return nearest;
}

/// False if the half-spaces have nothing in common.
bool ClearSpace::addAll(HalfSpaceProjection& projection, double farthest, double shrink) const {
  for (int n = 0; n < kMaxAdditions; ++n) {
    const int label = findViolated(projection, farthest, shrink);
    if (label < 0) return true;
    if (!projection.add(label, planes_[label].normal, planes_[label].offset - shrink)) return false;
  }
  return true;
}

HalfSpaceProjection ClearSpace::project(const Vector3d& target, double farthest) const {
  double size = radius_;
  for (int k = 0; k <= kMaxShrinks; ++k, size /= 2) {
    HalfSpaceProjection projection(target);
    if (addAll(projection, farthest, radius_ - size)) return projection;
  }
  return HalfSpaceProjection(position_);
}

Vector3d ClearSpace::nearestTouch(const Vector3d& target) const {
  const Plane* nearest = nullptr;
  for (int label = 0; label < count_; ++label) {
    const Plane& plane = planes_[label];
    const bool keeps = plane.normal.dot(target) < plane.offset;
    if (keeps && (nearest == nullptr || plane.gap < nearest->gap)) nearest = &plane;
  }
  if (nearest == nullptr) return position_;
  return nearestTo(position_ - nearest->gap * nearest->normal).point();
}

}  // namespace pleura::haptics
