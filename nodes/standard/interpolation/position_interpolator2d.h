#pragma once

#include <pleura/nodes/standard/interpolation/key_frame_interpolator.h>

namespace pleura {

/// Positions in a plane along a polyline of keys.
class PositionInterpolator2D : public KeyFrameInterpolator<MFVec2f, SFVec2f, LinearMix> {
 public:
  static void declare(NodeType& type);
};

}  // namespace pleura
