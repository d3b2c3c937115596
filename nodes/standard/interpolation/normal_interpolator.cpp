#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/normal_interpolator.h>

namespace pleura {

void NormalInterpolator::declare(NodeType& type) {
  X3DInterpolatorNode::declare(type);
  type.named("NormalInterpolator", "Interpolation", 2)
      .means("lists of normals between keys, on the unit sphere");
  using enum Access;
  type.field<&NormalInterpolator::keyValue>("keyValue", inputOutput, {})
      .means("the values at the keys, in order");
  type.field<&NormalInterpolator::value_changed>("value_changed", outputOnly, {})
      .means("the value at the fraction");
}

}  // namespace pleura
