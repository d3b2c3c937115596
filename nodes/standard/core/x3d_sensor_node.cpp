#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/core/x3d_sensor_node.h>

namespace pleura {

void X3DSensorNode::declare(NodeType& type) {
  Node::declare(type);
  using enum Access;
  type.field<&X3DSensorNode::description>("description", inputOutput, {})
      .means("what the sensor is for, told to the user");
  type.field<&X3DSensorNode::enabled>("enabled", inputOutput, true).means("whether the node reacts at all");
  type.field<&X3DSensorNode::isActive>("isActive", outputOnly, false)
      .means("whether the sensor is being triggered");
}

}  // namespace pleura
