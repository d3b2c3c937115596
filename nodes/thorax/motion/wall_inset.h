#pragma once

#include <pleura/nodes/thorax/motion/pleural_wall.h>

#include <span>

namespace pleura {

/// Sets wall.inset from the bones at inflation 1, whose displacements are given. A rib that is lifted also turns
/// within the wall, so that its edges come forward of the surface through what faced inwards at rest; the inset
/// is what takes the wall clear of them, spread over about 15 mm. Bodies as the wall was built from.
void setInset(PleuralWall& wall, std::span<const WallBody> bodies, std::span<const BodyDisplacement> displacements);

}  // namespace pleura
