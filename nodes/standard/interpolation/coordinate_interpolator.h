#pragma once

#include <pleura/nodes/standard/interpolation/key_frame_interpolator.h>

namespace pleura {

/// Lists of points between keys.
class CoordinateInterpolator : public KeyFrameInterpolator<MFVec3f, MFVec3f, LinearMix> {
 public:
  static void declare(NodeType& type);
};

}  // namespace pleura
