#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/navigation/collision.h>

namespace pleura {

void Collision::declare(NodeType& type) {
  X3DGroupingNode::declare(type);
  type.named("Collision", "Navigation", 2).means("children that the viewer may bump into");
  using enum Access;
  type.field<&Collision::description>("description", inputOutput, {})
      .means("what the sensor is for, told to the user");
  type.field<&Collision::enabled>("enabled", inputOutput, true).means("whether the node reacts at all");
  type.field<&Collision::proxy>("proxy", initializeOnly, {})
      .means("what is bumped into in place of the children");
  type.field<&Collision::collideTime>("collideTime", outputOnly, 0)
      .measuredIn(Unit::time)
      .means("when the viewer bumped last");
  type.field<&Collision::isActive>("isActive", outputOnly, false).means("whether the viewer touches it");
}

}  // namespace pleura
