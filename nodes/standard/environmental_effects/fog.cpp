#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/environmental_effects/fog.h>

namespace pleura {

void Fog::declare(NodeType& type) {
  X3DBindableNode::declare(type);
  X3DFogObject::declare(type);
  type.named("Fog", "EnvironmentalEffects", 2).means("haze that hides what is far away");
}

}  // namespace pleura
