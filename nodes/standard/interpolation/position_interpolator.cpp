#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/position_interpolator.h>

namespace pleura {

void PositionInterpolator::declare(NodeType& type) {
  X3DInterpolatorNode::declare(type);
  type.named("PositionInterpolator", "Interpolation", 1).means("positions along a polyline of keys");
  using enum Access;
  type.field<&PositionInterpolator::keyValue>("keyValue", inputOutput, {})
      .measuredIn(Unit::length)
      .means("the values at the keys, in order");
  type.field<&PositionInterpolator::value_changed>("value_changed", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("the value at the fraction");
}

}  // namespace pleura
