#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/lung/planar/hemithorax.h>

namespace pleura::planar {

/// The wall near a point x, as the contact sees it: the gap, and what its derivatives by (x, q) are made of.
struct WallGap {
  double gap = 0;                     // [m] from the wall inwards; of no use but its sign when it is not near
  bool isNear = false;                // what follows is filled in
  Eigen::Vector4d gradient;           // [1]
  Eigen::Vector4d along;              // motion along the wall [1]
  Eigen::Vector4d turn;               // of the wall where the foot is [1/m]
  double bend = 0;                    // [1/m] of the wall, positive towards x
  Eigen::Matrix4d curvature() const;  // second derivatives [1/m]
};

/// The wall with its corners rounded: the quadratic B-spline of its points, through the middles of its
/// segments, so that a lung slides along it without a catch and the gap's derivatives are continuous.
class RoundedWall {
 public:
  explicit RoundedWall(const ChestOutline& outline);

  /// Moves it with the chest. Does not allocate.
  void move(const Eigen::Vector2d& q);

  std::span<const Eigen::Vector2d> points() const { return points_; }

  /// The gap at x, with derivatives when it is less than `reach` [m].
  WallGap gapAt(const Eigen::Vector2d& x, double reach) const;

 private:
  /// Three points about one of the spline's pieces, and the piece as a polynomial.
  struct Piece {
    std::array<std::size_t, 3> points;
    Eigen::Vector2d start, slope, bend;  // c(s) = start + slope s + bend s^2 / 2, s in [0, 1]
  };
  /// A run of points about a middle one, for the search of the nearest.
  struct Run {
    std::size_t begin, end;
    Eigen::Vector2d middle;
    double radius;  // [m]
  };
  std::size_t nearest(const Eigen::Vector2d& x) const;
  Piece piece(std::size_t k) const;
  std::size_t next(std::size_t k) const { return k + 1 < points_.size() ? k + 1 : 0; }
  std::size_t before(std::size_t k) const { return k > 0 ? k - 1 : points_.size() - 1; }

  ChestOutline outline_;
  std::vector<Eigen::Vector2d> points_;
  std::vector<Run> runs_;
  double longest_ = 0;  // segment [m]
};

}  // namespace pleura::planar
