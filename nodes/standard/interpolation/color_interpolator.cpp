#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/color_interpolator.h>

namespace pleura {

void ColorInterpolator::declare(NodeType& type) {
  X3DInterpolatorNode::declare(type);
  type.named("ColorInterpolator", "Interpolation", 2)
      .means("colours between keys, in hue, saturation and value");
  using enum Access;
  type.field<&ColorInterpolator::keyValue>("keyValue", inputOutput, {})
      .within(0, 1)
      .means("the values at the keys, in order");
  type.field<&ColorInterpolator::value_changed>("value_changed", outputOnly, RGB::Zero())
      .within(0, 1)
      .means("the value at the fraction");
}

}  // namespace pleura
