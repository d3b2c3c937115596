#pragma once

#include <pleura/nodes/standard/interpolation/key_frame_interpolator.h>
#include <pleura/nodes/standard/interpolation/mixes.h>

namespace pleura {

/// Colours between keys, in hue, saturation and value.
class ColorInterpolator : public KeyFrameInterpolator<MFColor, SFColor, ColorMix> {
 public:
  static void declare(NodeType& type);
};

}  // namespace pleura
