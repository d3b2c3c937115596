#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/coordinate_interpolator.h>

namespace pleura {

void CoordinateInterpolator::declare(NodeType& type) {
  X3DInterpolatorNode::declare(type);
  type.named("CoordinateInterpolator", "Interpolation", 1).means("lists of points between keys");
  using enum Access;
  type.field<&CoordinateInterpolator::keyValue>("keyValue", inputOutput, {})
      .measuredIn(Unit::length)
      .means("the values at the keys, in order");
  type.field<&CoordinateInterpolator::value_changed>("value_changed", outputOnly, {})
      .measuredIn(Unit::length)
      .means("the value at the fraction");
}

}  // namespace pleura
