#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/navigation/viewpoint_group.h>

namespace pleura {

void ViewpointGroup::declare(NodeType& type) {
  Node::declare(type);
  type.named("ViewpointGroup", "Navigation", 3).means("viewpoints that belong together");
  using enum Access;
  type.field<&ViewpointGroup::center>("center", inputOutput, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("centre of the box in which the group is offered");
  type.field<&ViewpointGroup::children>("children", inputOutput, {}).means("viewpoints and groups of them");
  type.field<&ViewpointGroup::description>("description", inputOutput, {})
      .means("name of the group, shown to the user");
  type.field<&ViewpointGroup::displayed>("displayed", inputOutput, true)
      .means("whether the group is offered to the user");
  type.field<&ViewpointGroup::retainUserOffsets>("retainUserOffsets", inputOutput, false)
      .means("whether a move of the user's is kept on coming back");
  type.field<&ViewpointGroup::size>("size", inputOutput, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("size of the box in which the group is offered; 0 0 0: everywhere");
}

}  // namespace pleura
