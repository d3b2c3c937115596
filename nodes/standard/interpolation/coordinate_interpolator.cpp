#include <pleura/nodes/standard/interpolation/coordinate_interpolator.h>

namespace pleura {

void CoordinateInterpolator::declare(NodeType& type) {
  KeyFrameInterpolator::declare(type, Unit::length);
  type.named("CoordinateInterpolator", "Interpolation", 1).means("lists of points between keys");
}

}  // namespace pleura
