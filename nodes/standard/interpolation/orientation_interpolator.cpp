#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/orientation_interpolator.h>

namespace pleura {

void OrientationInterpolator::declare(NodeType& type) {
  X3DInterpolatorNode::declare(type);
  type.named("OrientationInterpolator", "Interpolation", 1)
      .means("turns from key to key, the shorter way round");
  using enum Access;
  type.field<&OrientationInterpolator::keyValue>("keyValue", inputOutput, {})
      .measuredIn(Unit::angle)
      .means("the values at the keys, in order");
  type.field<&OrientationInterpolator::value_changed>("value_changed", outputOnly, Rotation())
      .measuredIn(Unit::angle)
      .means("the value at the fraction");
}

}  // namespace pleura
