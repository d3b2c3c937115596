#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/x3d_interpolator_node.h>

namespace pleura {

void X3DInterpolatorNode::declare(NodeType& type) {
  Node::declare(type);
  using enum Access;
  type.field<&X3DInterpolatorNode::key>("key", inputOutput, {}).means("fractions, rising, one a key value");
  type.field<&X3DInterpolatorNode::set_fraction>("set_fraction", inputOnly, 0)
      .means("where between the keys");
}

}  // namespace pleura
