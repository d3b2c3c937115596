#include <pleura/nodes/standard/interpolation/coordinate_interpolator2d.h>

namespace pleura {

void CoordinateInterpolator2D::declare(NodeType& type) {
  KeyFrameInterpolator::declare(type, Unit::length);
  type.named("CoordinateInterpolator2D", "Interpolation", 3).means("lists of points in a plane between keys");
}

}  // namespace pleura
