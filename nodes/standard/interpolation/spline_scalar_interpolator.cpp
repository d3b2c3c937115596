#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/spline_scalar_interpolator.h>

namespace pleura {

void SplineScalarInterpolator::declare(NodeType& type) {
  X3DInterpolatorNode::declare(type);
  type.named("SplineScalarInterpolator", "Interpolation", 4)
      .means("numbers along a smooth curve through the keys");
  using enum Access;
  type.field<&SplineScalarInterpolator::closed>("closed", inputOutput, false)
      .means("whether the curve's end goes over into its beginning smoothly");
  type.field<&SplineScalarInterpolator::keyValue>("keyValue", inputOutput, {})
      .means("the values at the keys, in order");
  type.field<&SplineScalarInterpolator::keyVelocity>("keyVelocity", inputOutput, {})
      .means("velocities at the keys; empty: a Catmull-Rom curve");
  type.field<&SplineScalarInterpolator::normalizeVelocity>("normalizeVelocity", inputOutput, false)
      .means("whether the curve is run through at an even speed");
  type.field<&SplineScalarInterpolator::value_changed>("value_changed", outputOnly, 0)
      .means("the value at the fraction");
}

}  // namespace pleura
