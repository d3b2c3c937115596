#pragma once

#include <array>
#include <cmath>

#include <pleura/haptics/contact/four_boxes.h>
#include <pleura/haptics/contact/triangle_point.h>

namespace pleura::haptics {

/// Four triangles side by side in floats, to tell cheaply which of them do not matter. None that does is
/// missed: rounding is on the safe side. Places are relative to one that is near.
class FourTriangles {
 public:
  struct Ball {
    Ball(const Eigen::Vector3d& place, double distance)
        : centre(place.cast<float>()),
          squaredRadius(square(distance + kRounding * (distance + place.norm()))) {}

    Eigen::Vector3f centre;
    float squaredRadius;  // [m^2]

   private:
    static float square(double x) { return static_cast<float>(x) * static_cast<float>(x); }
  };

  /// normal . x <= offset; the normal is a unit vector.
  struct HalfSpace {
    HalfSpace(const Eigen::Vector3d& unit, double distance)
        : normal(unit.cast<float>()), offset(static_cast<float>(distance - kRounding * std::abs(distance))) {}
    Eigen::Vector3f normal;
    float offset;  // [m]
  };

  /// Puts a triangle at 0..3; bound() is called when they are there.
  void set(int at, const Corners& corners) {
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < 3; ++k) corners_[k](at, axis) = static_cast<float>(corners(axis, k));
  }

  void bound() {
    boxes_.low = corners_[0].min(corners_[1]).min(corners_[2]);
    boxes_.high = corners_[0].max(corners_[1]).max(corners_[2]);
    const FourPlaces size = boxes_.low.abs().max(boxes_.high.abs());
    rounding_ = static_cast<float>(kRounding) * (size.col(0) + size.col(1) + size.col(2));
    boxes_.low.colwise() -= rounding_;
    boxes_.high.colwise() += rounding_;
  }

  /// >= 0 only where no place of the triangle is in the ball.
  FourNumbers isFarther(const Ball& ball) const {
    return boxes_.squaredDistance(ball.centre) - ball.squaredRadius;
  }

  /// >= 0 only where all of the triangle is in the half-space.
  FourNumbers isBehind(const HalfSpace& half) const {
    const Eigen::Vector3f& n = half.normal;
    const auto along = [&n](const FourPlaces& c) {
      return n[0] * c.col(0) + n[1] * c.col(1) + n[2] * c.col(2);
    };
    return half.offset - (along(corners_[0]).max(along(corners_[1])).max(along(corners_[2])) + rounding_);
  }

 private:
  /// Of a distance: six roundings are between a corner and what its place along a normal is compared to.
  static constexpr double kRounding = 4e-7;

  FourBoxes boxes_;  // about the triangles
  std::array<FourPlaces, 3> corners_{boxes_.low, boxes_.low, boxes_.low};
  FourNumbers rounding_ = FourNumbers::Zero();
};

}  // namespace pleura::haptics
