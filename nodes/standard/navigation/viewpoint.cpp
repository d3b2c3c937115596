#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/navigation/viewpoint.h>

namespace pleura {

void Viewpoint::declare(NodeType& type) {
  X3DViewpointNode::declare(type);
  type.named("Viewpoint", "Navigation", 1).means("a place to look from, in perspective");
  using enum Access;
  type.field<&Viewpoint::centerOfRotation>("centerOfRotation", inputOutput, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("point that the viewer turns about");
  type.field<&Viewpoint::fieldOfView>("fieldOfView", inputOutput, 0.7854f)
      .measuredIn(Unit::angle)
      .positive(3.1416)
      .means("angle of the smaller side of the picture");
  type.field<&Viewpoint::position>("position", inputOutput, Vec3f(0, 0, 10))
      .measuredIn(Unit::length)
      .means("where the camera stands");
}

}  // namespace pleura
