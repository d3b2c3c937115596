#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/navigation/x3d_viewpoint_node.h>

namespace pleura {

void X3DViewpointNode::declare(NodeType& type) {
  X3DBindableNode::declare(type);
  using enum Access;
  type.field<&X3DViewpointNode::description>("description", inputOutput, {})
      .means("name of the viewpoint, shown to the user");
  type.field<&X3DViewpointNode::farDistance>("farDistance", inputOutput, -1)
      .measuredIn(Unit::length)
      .means("distance of the far plane; -1: chosen");
  type.field<&X3DViewpointNode::jump>("jump", inputOutput, true)
      .means("whether binding moves the viewer here");
  type.field<&X3DViewpointNode::navigationInfo>("navigationInfo", inputOutput, {})
      .means("how the viewer moves while here");
  type.field<&X3DViewpointNode::nearDistance>("nearDistance", inputOutput, -1)
      .measuredIn(Unit::length)
      .means("distance of the near plane; -1: chosen");
  type.field<&X3DViewpointNode::orientation>("orientation", inputOutput, Rotation())
      .measuredIn(Unit::angle)
      .means("turn of the camera from looking along -z");
  type.field<&X3DViewpointNode::retainUserOffsets>("retainUserOffsets", inputOutput, false)
      .means("whether a move of the user's is kept on coming back");
  type.field<&X3DViewpointNode::viewAll>("viewAll", inputOutput, false)
      .means("whether the view is changed to show everything");
}

}  // namespace pleura
