#pragma once

#include <pleura/nodes/thorax/anatomy/anatomy.h>

#include <vector>

namespace pleura {

/// Ribs 1-12, left then right, swept through the measured stations (measurements/ribs.csv, ribs_summary.csv).
std::vector<Rib> generateRibs();

}  // namespace pleura
