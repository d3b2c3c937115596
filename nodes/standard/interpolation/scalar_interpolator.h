#pragma once

#include <pleura/nodes/standard/interpolation/key_frame_interpolator.h>

namespace pleura {

/// Numbers along a polyline of keys.
class ScalarInterpolator : public KeyFrameInterpolator<MFFloat, SFFloat, LinearMix> {
 public:
  static void declare(NodeType& type);
};

}  // namespace pleura
