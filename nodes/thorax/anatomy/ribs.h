#pragma once

#include <vector>

#include <pleura/nodes/thorax/anatomy/anatomy.h>

namespace pleura {

/// Ribs 1-12, left then right, swept through the measured stations (measurements/ribs.csv, ribs_summary.csv).
std::vector<Rib> generateRibs();

}  // namespace pleura
