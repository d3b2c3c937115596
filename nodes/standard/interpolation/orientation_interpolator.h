#pragma once

#include <pleura/nodes/standard/interpolation/key_frame_interpolator.h>
#include <pleura/nodes/standard/interpolation/mixes.h>

namespace pleura {

/// Turns from key to key, the shorter way round.
class OrientationInterpolator : public KeyFrameInterpolator<MFRotation, SFRotation, RotationMix> {
 public:
  static void declare(NodeType& type);
};

}  // namespace pleura
