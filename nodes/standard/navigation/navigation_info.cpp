#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/navigation/navigation_info.h>

namespace pleura {

void NavigationInfo::declare(NodeType& type) {
  X3DBindableNode::declare(type);
  type.named("NavigationInfo", "Navigation", 1).means("how the viewer moves");
  using enum Access;
  type.field<&NavigationInfo::avatarSize>("avatarSize", inputOutput, {0.25f, 1.6f, 0.75f})
      .measuredIn(Unit::length)
      .atLeast(0)
      .means("distance to what is bumped into, height of the eyes, height of a step");
  type.field<&NavigationInfo::headlight>("headlight", inputOutput, true)
      .means("whether a light shines along the line of sight");
  type.field<&NavigationInfo::speed>("speed", inputOutput, 1)
      .measuredIn(Unit::speed)
      .atLeast(0)
      .means("speed of travel");
  type.field<&NavigationInfo::transitionTime>("transitionTime", inputOutput, 1)
      .measuredIn(Unit::time)
      .atLeast(0)
      .means("time that a move to another viewpoint takes");
  type.field<&NavigationInfo::transitionType>("transitionType", inputOutput, {"LINEAR"})
      .means("TELEPORT, LINEAR or ANIMATE");
  type.field<&NavigationInfo::navigationType>("type", inputOutput, {"EXAMINE", "ANY"})
      .means("ways of moving: ANY, WALK, EXAMINE, FLY, LOOKAT, NONE, EXPLORE");
  type.field<&NavigationInfo::visibilityLimit>("visibilityLimit", inputOutput, 0)
      .measuredIn(Unit::length)
      .atLeast(0)
      .means("distance beyond which nothing is drawn; 0: none");
  type.field<&NavigationInfo::transitionComplete>("transitionComplete", outputOnly, false)
      .means("a move to another viewpoint has ended");
}

}  // namespace pleura
