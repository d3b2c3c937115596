#pragma once

#include <vector>

#include <pleura/nodes/thorax/anatomy/anatomy.h>

namespace pleura {

/// T1-T12 and the discs below them (measurements/vertebrae.csv): bodies of the measured size, arches and
/// processes drawn to the measured tips.
std::vector<Vertebra> generateVertebrae();

}  // namespace pleura
