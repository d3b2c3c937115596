#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/thorax/motion/pleural_wall.h>

namespace pleura {

/// How pleural surfaces slide on a wall. Down each column v runs from 0 at the cupola over 1 at the fold
/// (upper border of the zone of apposition) to 2 at the rim of the diaphragm. When the diaphragm contracts
/// the fold goes down by `drop`; cupola and rim stay. Above the fold the slide is 3 v^2 - 2 v^3 of that,
/// below it fades linearly.
struct WallSlide {
  std::vector<double> fold;  // [kColumns] row of the fold at rest
  std::vector<double> rim;   // [kColumns] row of the rim
  std::vector<double> drop;  // [kColumns] rows that the fold goes down at contraction 1

  /// Row on a column of what lies at v at rest.
  double row(int column, double v, double contraction) const {
    const auto c = static_cast<std::size_t>(column);
    const double slide = contraction * drop[c];
    const double zone = rim[c] - fold[c];
    if (v <= 1.0) return v * fold[c] + v * v * (3.0 - 2.0 * v) * slide;
    return v <= 2.0 ? fold[c] + (v - 1.0) * zone + (2.0 - v) * slide : rim[c] + (v - 2.0) * zone;
  }
};

/// Fold and rim on a wall from points [m] of the diaphragm's edge of the dome and of its rim; columns that no
/// point meets take their neighbours' rows. The fold drops by `drop` [m] but leaves three tenths of the zone
/// of apposition. Throws std::invalid_argument when no point lies near the wall or the drop is not finite.
WallSlide slideOnWall(const PleuralWall& wall, std::span<const Eigen::Vector3d> fold,
                      std::span<const Eigen::Vector3d> rim, double drop);

}  // namespace pleura
