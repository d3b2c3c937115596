#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <pleura/haptics/contact/four_triangles.h>
#include <pleura/haptics/contact/touch_shape.h>

namespace pleura::haptics {

/// The shapes and triangles about the proxy, and what is remembered of a shape while it is near: how it stood
/// at the last tick, whether the ball feels it, and where the ball is as seen by the shape's own motion.
class Neighbourhood {
 public:
  static constexpr int kMaxShapes = 32;
  static constexpr int kMaxTriangles = 512;

  struct Shape {
    TouchShape now;
    std::uint64_t mesh = 0, from = 0, to = 0;  // serials
    /// False for a shape whose back the ball is at, or that stood in the ball when it appeared: such a one is
    /// not felt until the ball is clear of it.
    bool felt = false;
    bool isJudged = false;  // whether `felt` is known
    /// Where the ball would be had the shape taken it along since the last tick: from there everything is on
    /// the side of the ball that it was on.
    Eigen::Vector3d view = Eigen::Vector3d::Zero();
    Eigen::Vector3d motion =
        Eigen::Vector3d::Zero();  // [m] since the last tick, where it is nearest to the ball
    int likely = -1;         // of triangles(): the one that is nearest to the ball, as far as is known; or -1
    int likelyIndex = -1;    // the same, of the mesh
    int begin = 0, end = 0;  // its triangles: triangles()[begin] and on, up to before end
  };

  struct Triangle {
    Corners corners;  // in the world
    int shape;        // index into shapes()
    int index;        // of the shape's mesh
  };

  void clear();

  /// A tick begins: shapes have moved or vanished. `position` is the ball's, whose radius is given.
  void advance(std::span<const TouchShape> shapes, const Eigen::Vector3d& position);

  /// Sees to it that all triangles are there that are nearer than `reach` to `position` (a shape's: to its
  /// view); beyond `always` only while they are few, and none for which there is no room. Returns the reach
  /// that it came to, at least `radius`.
  double gather(std::span<const TouchShape> shapes, const Eigen::Vector3d& position, double radius,
                double always, double reach);

  /// The ball has gone to `position`: all views are there.
  void moveTo(const Eigen::Vector3d& position);

  /// The triangle is the nearest of its shape, and worth a look first from now on.
  void expect(int triangle);

  /// Counts what changes what is around: another number, other surroundings.
  unsigned changes() const { return changes_; }

  /// The ball has come to rest at `position`: tells which shapes it feels.
  void settle(const Eigen::Vector3d& position, double radius);

  std::span<const Shape> shapes() const { return {shapes_.data(), static_cast<std::size_t>(shapeCount_)}; }
  struct Nearest {
    int triangle = -1;  // index into triangles(), or -1
    TrianglePoint on;
    double distance = 0;  // [m]
  };
  /// Where those triangles of a shape that are here are nearest to a point and nearer than `within` [m].
  Nearest nearest(const Shape& shape, const Eigen::Vector3d& point, double within) const;

  /// visit(index) is called for the triangles of a shape that may be nearer than `reach` [m] to a point.
  template <class Visit>
  void visitWithin(const Shape& shape, const Eigen::Vector3d& point, double reach, Visit visit) const;

  /// The same, but most of those that have normal . x <= offset are left out; normal is a unit vector.
  template <class Visit>
  void visitInFront(const Shape& shape, const Eigen::Vector3d& point, double reach,
                    const Eigen::Vector3d& normal, double offset, Visit visit) const;

  std::span<const Triangle> triangles() const {
    return {triangles_.data(), static_cast<std::size_t>(count_)};
  }

 private:
  /// visit(index) is called where signs(fours_[index / 4])[index % 4] < 0.
  template <class Signs, class Visit>
  void visitNegative(const Shape& shape, Signs signs, Visit visit) const;

  void add(const TouchShape& shape, int index);
  double reachOf(const Shape& shape) const { return reach_ + (shape.view - centre_).norm(); }
  bool isInFront(const Shape& shape, const Nearest& at, const Eigen::Vector3d& point) const;
  int find(std::uint32_t id) const;
  void judge(Shape& shape, double radius, double reach);
  void carry(Shape& shape, const TouchShape& next, const Eigen::Vector3d& position) const;
  bool collect(std::span<const TouchShape> shapes, const Eigen::Vector3d& position, double radius,
               double reach, bool partly, const Eigen::Vector3d& lead);

  std::array<Shape, kMaxShapes> shapes_;
  std::array<Triangle, kMaxTriangles> triangles_;
  std::array<FourTriangles, kMaxTriangles / 4> fours_;  // the same, relative to centre_
  int shapeCount_ = 0;
  int count_ = 0;
  bool valid_ = false;
  bool moving_ = false;  // some shape, at this tick
  unsigned changes_ = 0;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();  // all triangles are there that are nearer to it than
  double reach_ = 0;
};

template <class Signs, class Visit>
void Neighbourhood::visitNegative(const Shape& shape, Signs signs, Visit visit) const {
  // told first and visited then: a branch for each would be guessed wrong every other time
  std::array<int, kMaxTriangles + 4> found;
  int count = 0;
  for (int four = shape.begin / 4; four * 4 < shape.end; ++four)
    count += putNegative(signs(fours_[four]), 4 * four, &found[count]);
  for (int i = 0; i < count; ++i)
    if (found[i] >= shape.begin && found[i] < shape.end) visit(found[i]);
}

template <class Visit>
void Neighbourhood::visitWithin(const Shape& shape, const Eigen::Vector3d& point, double reach,
                                Visit visit) const {
  const FourTriangles::Ball ball(point - centre_, reach);
  visitNegative(
      shape, [&](const FourTriangles& four) { return four.isFarther(ball); }, visit);
}

template <class Visit>
void Neighbourhood::visitInFront(const Shape& shape, const Eigen::Vector3d& point, double reach,
                                 const Eigen::Vector3d& normal, double offset, Visit visit) const {
  const FourTriangles::Ball ball(point - centre_, reach);
  const FourTriangles::HalfSpace behind(normal, offset - normal.dot(centre_));
  visitNegative(
      shape,
      [&](const FourTriangles& four) -> FourNumbers {
        return four.isFarther(ball).max(four.isBehind(behind));
      },
      visit);
}

}  // namespace pleura::haptics
