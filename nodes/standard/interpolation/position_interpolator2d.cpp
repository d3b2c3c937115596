#include <pleura/nodes/standard/interpolation/position_interpolator2d.h>

namespace pleura {

void PositionInterpolator2D::declare(NodeType& type) {
  KeyFrameInterpolator::declare(type, Unit::length);
  type.named("PositionInterpolator2D", "Interpolation", 3)
      .means("positions in a plane along a polyline of keys");
}

}  // namespace pleura
