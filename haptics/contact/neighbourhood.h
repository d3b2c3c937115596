#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <pleura/haptics/contact/touch_shape.h>

namespace pleura::haptics {

/// The shapes and triangles about the proxy, and what is remembered of a shape while it is near: how it stood
/// at the last tick, whether the ball feels it, and where the ball is as seen by the shape's own motion.
class Neighbourhood {
 public:
  static constexpr int kMaxShapes = 32;
  static constexpr int kMaxTriangles = 256;

  struct Shape {
    TouchShape now;
    std::uint64_t mesh, from, to;  // serials
    /// False for a shape whose back the ball is at, or that stood in the ball when it appeared: such a one is
    /// not felt until the ball is clear of it.
    bool felt;
    /// Where the ball would be had the shape taken it along since the last tick: from there everything is on
    /// the side of the ball that it was on.
    Eigen::Vector3d view;
    Eigen::Vector3d motion;  // [m] that it went since the last tick, where it is nearest to the ball
  };

  struct Triangle {
    Corners corners;  // in the world
    Eigen::Vector3d centre;
    double radius;  // of a ball about the centre, with all corners in it
    int shape;      // index into shapes()
    int index;      // of the shape's mesh
  };

  void clear();

  /// A tick begins: shapes have moved or vanished. `position` is the ball's, whose radius is given.
  void advance(std::span<const TouchShape> shapes, const Eigen::Vector3d& position);

  /// Sees to it that all triangles are there that are nearer than `reach` to `position` (a shape's: to its
  /// view), where there is room. Returns the reach that there was room for, at least `radius`.
  double gather(std::span<const TouchShape> shapes, const Eigen::Vector3d& position, double radius,
                double reach);

  /// The ball has gone to `position`: all views are there.
  void moveTo(const Eigen::Vector3d& position);

  /// The ball has come to rest at `position`: tells which shapes it feels.
  void settle(const Eigen::Vector3d& position, double radius);

  std::span<const Shape> shapes() const { return {shapes_.data(), static_cast<std::size_t>(shapeCount_)}; }
  std::span<const Triangle> triangles() const {
    return {triangles_.data(), static_cast<std::size_t>(count_)};
  }

 private:
  struct Nearest {
    int triangle = -1;  // index into triangles_
    TrianglePoint on;
    double distance = 0;
  };

  Nearest nearest(int shape, const Eigen::Vector3d& point) const;
  int find(std::uint32_t id) const;
  bool carry(Shape& shape, const TouchShape& next, const Eigen::Vector3d& position) const;
  bool collect(std::span<const TouchShape> shapes, const Eigen::Vector3d& position, double radius,
               double reach, bool partly);

  std::array<Shape, kMaxShapes> shapes_;
  std::array<Triangle, kMaxTriangles> triangles_;
  int shapeCount_ = 0;
  int count_ = 0;
  bool valid_ = false;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();  // all triangles are there that are nearer to it than
  double reach_ = 0;
};

}  // namespace pleura::haptics
