#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/coordinate_interpolator2d.h>

namespace pleura {

void CoordinateInterpolator2D::declare(NodeType& type) {
  X3DInterpolatorNode::declare(type);
  type.named("CoordinateInterpolator2D", "Interpolation", 3).means("lists of points in a plane between keys");
  using enum Access;
  type.field<&CoordinateInterpolator2D::keyValue>("keyValue", inputOutput, {})
      .measuredIn(Unit::length)
      .means("the values at the keys, in order");
  type.field<&CoordinateInterpolator2D::value_changed>("value_changed", outputOnly, {})
      .measuredIn(Unit::length)
      .means("the value at the fraction");
}

}  // namespace pleura
