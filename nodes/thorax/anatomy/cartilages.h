#pragma once

#include <vector>

#include <pleura/nodes/thorax/anatomy/anatomy.h>

namespace pleura {

/// Costal cartilages 1-10, left then right (measurements/cartilages.csv), grown into the ends of their ribs
/// and into what they join: 1-7 the sternum, 8-10 the cartilage above.
std::vector<Cartilage> generateCartilages(const std::vector<Rib>& ribs);

}  // namespace pleura
