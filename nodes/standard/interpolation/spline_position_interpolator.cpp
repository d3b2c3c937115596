#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/spline_position_interpolator.h>

namespace pleura {

void SplinePositionInterpolator::declare(NodeType& type) {
  X3DInterpolatorNode::declare(type);
  type.named("SplinePositionInterpolator", "Interpolation", 4)
      .means("positions along a smooth curve through the keys");
  using enum Access;
  type.field<&SplinePositionInterpolator::closed>("closed", inputOutput, false)
      .means("whether the curve's end goes over into its beginning smoothly");
  type.field<&SplinePositionInterpolator::keyValue>("keyValue", inputOutput, {})
      .measuredIn(Unit::length)
      .means("the values at the keys, in order");
  type.field<&SplinePositionInterpolator::keyVelocity>("keyVelocity", inputOutput, {})
      .means("velocities at the keys; empty: a Catmull-Rom curve");
  type.field<&SplinePositionInterpolator::normalizeVelocity>("normalizeVelocity", inputOutput, false)
      .means("whether the curve is run through at an even speed");
  type.field<&SplinePositionInterpolator::value_changed>("value_changed", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("the value at the fraction");
}

}  // namespace pleura
