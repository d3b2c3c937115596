#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/environmental_effects/background.h>

namespace pleura {

void Background::declare(NodeType& type) {
  X3DBackgroundNode::declare(type);
  type.named("Background", "EnvironmentalEffects", 1).means("sky, ground and panorama");
  using enum Access;
  type.field<&Background::backUrl>("backUrl", inputOutput, {}).means("picture behind");
  type.field<&Background::bottomUrl>("bottomUrl", inputOutput, {}).means("picture below");
  type.field<&Background::frontUrl>("frontUrl", inputOutput, {}).means("picture in front");
  type.field<&Background::leftUrl>("leftUrl", inputOutput, {}).means("picture on the left");
  type.field<&Background::rightUrl>("rightUrl", inputOutput, {}).means("picture on the right");
  type.field<&Background::topUrl>("topUrl", inputOutput, {}).means("picture above");
}

}  // namespace pleura
