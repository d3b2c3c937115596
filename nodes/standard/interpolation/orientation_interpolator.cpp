#include <pleura/nodes/standard/interpolation/orientation_interpolator.h>

namespace pleura {

void OrientationInterpolator::declare(NodeType& type) {
  KeyFrameInterpolator::declare(type, Unit::angle);
  type.named("OrientationInterpolator", "Interpolation", 1)
      .means("turns from key to key, the shorter way round");
}

}  // namespace pleura
