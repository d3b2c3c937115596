#pragma once

#include <pleura/nodes/standard/interpolation/key_frame_interpolator.h>
#include <pleura/nodes/standard/interpolation/mixes.h>

namespace pleura {

/// Lists of normals between keys, on the unit sphere.
class NormalInterpolator : public KeyFrameInterpolator<MFVec3f, MFVec3f, NormalMix> {
 public:
  static void declare(NodeType& type);
};

}  // namespace pleura
