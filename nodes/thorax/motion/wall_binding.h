#pragma once

#include <pleura/nodes/thorax/motion/pleural_wall.h>

#include <Eigen/Core>
#include <span>
#include <vector>

namespace pleura {

/// How the pleural surfaces slide on a wall. Along each profile v runs from 0 at the cupola over 1 at the fold
/// (upper border of the zone of apposition) to 2 at the rim of the diaphragm. When the diaphragm contracts the
/// fold goes down by `drop`, the cupola and the rim stay, and what lies between slides in proportion.
struct WallSlide {
  std::vector<double> fold;  // [kColumns] row of the fold at rest
  std::vector<double> rim;   // [kColumns] row of the rim
  std::vector<double> drop;  // [kColumns] rows that the fold goes down at inflation 1

  /// Row of coordinate v on a column.
  double row(int column, double v, double inflation) const {
    const auto c = static_cast<std::size_t>(column);
    const double zone = rim[c] - fold[c];
    const double slide = inflation * drop[c];
    if (v <= 1.0) return v * (fold[c] + slide);
    return v <= 2.0 ? fold[c] + (v - 1.0) * zone + (2.0 - v) * slide : rim[c] + (v - 2.0) * zone;
  }
};

/// A point near the wall: between columns `column` and the next at `fraction`, at v along them, `gap` inwards.
struct WallPoint {
  int column = 0;
  double fraction = 0.0;  // [0, 1)
  double v = 0.0;
  double gap = 0.0;                                     // [m] along the normal, negative outside
  Eigen::Vector3d remainder = Eigen::Vector3d::Zero();  // [m] what column, v and gap leave of the rest point
  bool bound = false;                                   // false where the cage is open (mediastinum)
};

/// Finds the nearest point of the wall within the half-plane of `point`.
WallPoint bindToWall(const PleuralWall& wall, const WallSlide& slide, const Eigen::Vector3d& point);

/// Where a bound point is now, given the moved wall.
Eigen::Vector3d followWall(const PleuralWall& wall, std::span<const Eigen::Vector3d> now, const WallSlide& slide,
                           const WallPoint& point, double inflation);

}  // namespace pleura
