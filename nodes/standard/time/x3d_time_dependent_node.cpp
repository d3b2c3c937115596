#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/time/x3d_time_dependent_node.h>

namespace pleura {

void X3DTimeDependentNode::declare(NodeType& type) {
  Node::declare(type);
  using enum Access;
  type.field<&X3DTimeDependentNode::description>("description", inputOutput, {})
      .means("what the node is for, told to the user");
  type.field<&X3DTimeDependentNode::pauseTime>("pauseTime", inputOutput, 0)
      .measuredIn(Unit::time)
      .means("when it pauses");
  type.field<&X3DTimeDependentNode::resumeTime>("resumeTime", inputOutput, 0)
      .measuredIn(Unit::time)
      .means("when it goes on again");
  type.field<&X3DTimeDependentNode::startTime>("startTime", inputOutput, 0)
      .measuredIn(Unit::time)
      .means("when it starts");
  type.field<&X3DTimeDependentNode::stopTime>("stopTime", inputOutput, 0)
      .measuredIn(Unit::time)
      .means("when it stops, if after startTime");
  type.field<&X3DTimeDependentNode::elapsedTime>("elapsedTime", outputOnly, 0)
      .measuredIn(Unit::time)
      .means("time it has run, pauses left out");
  type.field<&X3DTimeDependentNode::isActive>("isActive", outputOnly, false)
      .means("whether it runs or pauses");
  type.field<&X3DTimeDependentNode::isPaused>("isPaused", outputOnly, false).means("whether it pauses");
}

}  // namespace pleura
