#pragma once

#include <pleura/nodes/standard/interpolation/key_frame_interpolator.h>

namespace pleura {

/// Positions along a polyline of keys.
class PositionInterpolator : public KeyFrameInterpolator<MFVec3f, SFVec3f, LinearMix> {
 public:
  static void declare(NodeType& type);
};

}  // namespace pleura
