#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/scalar_interpolator.h>

namespace pleura {

void ScalarInterpolator::declare(NodeType& type) {
  X3DInterpolatorNode::declare(type);
  type.named("ScalarInterpolator", "Interpolation", 1).means("numbers along a polyline of keys");
  using enum Access;
  type.field<&ScalarInterpolator::keyValue>("keyValue", inputOutput, {})
      .means("the values at the keys, in order");
  type.field<&ScalarInterpolator::value_changed>("value_changed", outputOnly, 0)
      .means("the value at the fraction");
}

}  // namespace pleura
