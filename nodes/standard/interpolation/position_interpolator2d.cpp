#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/position_interpolator2d.h>

namespace pleura {

void PositionInterpolator2D::declare(NodeType& type) {
  X3DInterpolatorNode::declare(type);
  type.named("PositionInterpolator2D", "Interpolation", 3)
      .means("positions in a plane along a polyline of keys");
  using enum Access;
  type.field<&PositionInterpolator2D::keyValue>("keyValue", inputOutput, {})
      .measuredIn(Unit::length)
      .means("the values at the keys, in order");
  type.field<&PositionInterpolator2D::value_changed>("value_changed", outputOnly, Vec2f::Zero())
      .measuredIn(Unit::length)
      .means("the value at the fraction");
}

}  // namespace pleura
