#pragma once

#include <pleura/nodes/thorax/anatomy/anatomy.h>

#include <vector>

namespace pleura {

/// Ribs 1-12, left then right, swept through the measured stations (measurements/ribs.csv, ribs_summary.csv).
std::vector<Rib> generateRibs();

/// The point inside the chest that a rib's inner surface looks at from a point of its centreline: on the
/// middle axis of that side's lung, at the same height but not above its shoulder (so that rib 1 looks down).
Eigen::Vector3d lungAxisNear(const Eigen::Vector3d& point, Side side);

}  // namespace pleura
