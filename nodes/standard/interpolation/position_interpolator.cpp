#include <pleura/nodes/standard/interpolation/position_interpolator.h>

namespace pleura {

void PositionInterpolator::declare(NodeType& type) {
  KeyFrameInterpolator::declare(type, Unit::length);
  type.named("PositionInterpolator", "Interpolation", 1).means("positions along a polyline of keys");
}

}  // namespace pleura
