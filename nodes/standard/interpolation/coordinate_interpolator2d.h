#pragma once

#include <pleura/nodes/standard/interpolation/key_frame_interpolator.h>

namespace pleura {

/// Lists of points in a plane between keys.
class CoordinateInterpolator2D : public KeyFrameInterpolator<MFVec2f, MFVec2f, LinearMix> {
 public:
  static void declare(NodeType& type);
};

}  // namespace pleura
