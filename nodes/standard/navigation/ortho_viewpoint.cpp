#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/navigation/ortho_viewpoint.h>

namespace pleura {

void OrthoViewpoint::declare(NodeType& type) {
  X3DViewpointNode::declare(type);
  type.named("OrthoViewpoint", "Navigation", 3).means("a place to look from, without perspective");
  using enum Access;
  type.field<&OrthoViewpoint::centerOfRotation>("centerOfRotation", inputOutput, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("point that the viewer turns about");
  type.field<&OrthoViewpoint::fieldOfView>("fieldOfView", inputOutput, {-1, -1, 1, 1})
      .measuredIn(Unit::length)
      .means("left, bottom, right and top of what is shown at least");
  type.field<&OrthoViewpoint::position>("position", inputOutput, Vec3f(0, 0, 10))
      .measuredIn(Unit::length)
      .means("where the camera stands");
}

}  // namespace pleura
