#include <pleura/nodes/standard/interpolation/color_interpolator.h>

namespace pleura {

void ColorInterpolator::declare(NodeType& type) {
  KeyFrameInterpolator::declare(type, Unit::none, 0, 1);
  type.named("ColorInterpolator", "Interpolation", 2)
      .means("colours between keys, in hue, saturation and value");
}

}  // namespace pleura
