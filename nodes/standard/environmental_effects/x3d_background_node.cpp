#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/environmental_effects/x3d_background_node.h>

namespace pleura {

void X3DBackgroundNode::declare(NodeType& type) {
  X3DBindableNode::declare(type);
  using enum Access;
  type.field<&X3DBackgroundNode::groundAngle>("groundAngle", inputOutput, {})
      .measuredIn(Unit::angle)
      .within(0, 1.5708)
      .means("angles from straight down at which the ground colours stand");
  type.field<&X3DBackgroundNode::groundColor>("groundColor", inputOutput, {})
      .within(0, 1)
      .means("colours of the ground, one more than angles");
  type.field<&X3DBackgroundNode::skyAngle>("skyAngle", inputOutput, {})
      .measuredIn(Unit::angle)
      .within(0, 3.1416)
      .means("angles from straight up at which the sky colours stand");
  type.field<&X3DBackgroundNode::skyColor>("skyColor", inputOutput, {RGB::Zero()})
      .within(0, 1)
      .means("colours of the sky, one more than angles");
  type.field<&X3DBackgroundNode::transparency>("transparency", inputOutput, 0)
      .within(0, 1)
      .means("how much is seen through the background");
}

}  // namespace pleura
