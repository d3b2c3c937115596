#pragma once

#include <vector>

#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/anatomy/tube.h>

namespace pleura {

/// The point inside the chest that a bone of the wall looks at from a point of its centreline: on the middle
/// axis of that side's lung, at the same height but not above its shoulder (so that rib 1 looks down).
Eigen::Vector3d lungAxisNear(const Eigen::Vector3d& point, Side side);

/// The points of a tube that face the lung, at `samples` equal arc lengths.
std::vector<Eigen::Vector3f> innerLine(const Tube& tube, Side side, int samples);

}  // namespace pleura
