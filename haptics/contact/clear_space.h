#pragma once

#include <array>
#include <limits>

#include <pleura/haptics/contact/half_space_projection.h>
#include <pleura/haptics/contact/neighbourhood.h>

namespace pleura::haptics {

/// Where a ball may go on a straight way without meeting a triangle.
///
/// A triangle is convex, so it lies on one side of the plane through its point nearest to the ball's centre
/// and across the way there. As long as the centre stays one radius off that plane on the other side, the
/// whole way is clear of the triangle. So it is where another plane does the same: a neighbour's that the
/// triangle is behind, or the triangle's own.
class ClearSpace {
 public:
  /// The half-space that a triangle leaves to the centre: normal . x >= offset.
  struct Plane {
    Eigen::Vector3d normal;
    double offset;
    double gap;  // [m] between ball and triangle
    TrianglePoint on;
    int triangle;  // index into the neighbourhood's
  };

  /// Looks about from `position`, as far as a ball gets that goes reach - radius; free where nothing has
  /// changed since the last look. `near` must have what there is, and outlive the projections.
  void look(Neighbourhood& near, const Eigen::Vector3d& position, double radius, double reach);

  /// [m] that the centre may go without meeting what wasn't looked at.
  double range() const { return range_; }

  /// The place nearest to the target that can be reached; a label of its active() is an index for plane(). A
  /// ball that is squeezed gives way.
  HalfSpaceProjection nearestTo(const Eigen::Vector3d& target) const { return project(target, kEverywhere); }

  /// The same with nothing in the way but what the ball touches.
  HalfSpaceProjection alongTouched(const Eigen::Vector3d& target) const { return project(target, kTouch); }

  /// The nearest place where the ball touches something that keeps it from the target; where it is if nothing
  /// does that was looked at.
  Eigen::Vector3d nearestTouch(const Eigen::Vector3d& target) const;

  int count() const { return count_; }
  const Plane& plane(int label) const { return planes_[label]; }
  const Neighbourhood::Shape& shape(int label) const { return shapeOf(planes_[label].triangle); }
  bool touches(int label) const { return planes_[label].gap <= kTouch; }
  int meshTriangle(int label) const { return triangle(planes_[label].triangle).index; }

 private:
  static constexpr int kMaxPlanes = 64;
  static constexpr double kEverywhere = std::numeric_limits<double>::max();
  static constexpr double kTouch = 1e-6;  // [m] a smaller gap is contact

  const Neighbourhood::Triangle& triangle(int index) const { return near_->triangles()[index]; }
  const Neighbourhood::Shape& shapeOf(int index) const { return near_->shapes()[triangle(index).shape]; }
  bool makePlane(const Neighbourhood::Shape& shape, int triangle, double farthest, Plane& plane) const;
  bool isBehind(int triangle, const Plane& plane) const;
  bool keep(const Plane& plane);
  void tellNearest(Neighbourhood& near);
  bool covers(const Plane& plane, const Plane& other, const Eigen::Vector3d& point, double shrink) const;
  bool isCovered(int label, const HalfSpaceProjection& projection, double shrink) const;
  int findViolated(const HalfSpaceProjection& projection, double farthest, double shrink) const;
  bool addAll(HalfSpaceProjection& projection, double farthest, double shrink) const;
  HalfSpaceProjection project(const Eigen::Vector3d& target, double farthest) const;

  const Neighbourhood* near_ = nullptr;
  unsigned seen_ = 0;  // of the neighbourhood's changes
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();
  double radius_ = 0;
  double range_ = 0;
  std::array<Plane, kMaxPlanes> planes_;
  int count_ = 0;
  int nearest_ = -1;                                    // label
  std::array<int, Neighbourhood::kMaxShapes> screens_;  // a shape's triangle whose plane is kept to, or -1
};

}  // namespace pleura::haptics
