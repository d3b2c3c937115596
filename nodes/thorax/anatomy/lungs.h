#pragma once

#include <vector>

#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/anatomy/diaphragm.h>

namespace pleura {

/// Gap left between a lung at rest and bone or diaphragm: the two pleurae and what is between them.
inline constexpr double kPleuralGap = 0.0015;  // [m]

/// Left and right lung: the measured outlines towards heart and spine (measurements/lungs.csv), elsewhere
/// grown out to the chest wall and down to the diaphragm. `rest` has everything but the lungs.
std::vector<Lung> generateLungs(const Anatomy& rest, const std::array<ChestWall, 2>& walls,
                                const DiaphragmShape& shape);

}  // namespace pleura
