#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/navigation/billboard.h>

namespace pleura {

void Billboard::declare(NodeType& type) {
  X3DGroupingNode::declare(type);
  type.named("Billboard", "Navigation", 2).means("children that turn to the viewer");
  using enum Access;
  type.field<&Billboard::axisOfRotation>("axisOfRotation", inputOutput, Vec3f(0, 1, 0))
      .means("axis it turns about; 0 0 0: always faces the viewer");
}

}  // namespace pleura
