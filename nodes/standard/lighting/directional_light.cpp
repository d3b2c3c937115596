#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/lighting/directional_light.h>

namespace pleura {

void DirectionalLight::declare(NodeType& type) {
  X3DLightNode::declare(type);
  type.named("DirectionalLight", "Lighting", 1).means("light from one direction");
  using enum Access;
  type.field<&DirectionalLight::direction>("direction", inputOutput, Vec3f(0, 0, -1))
      .means("where the light goes");
  type.field<&DirectionalLight::global>("global", inputOutput, false)
      .means("whether it lights the whole scene, or its siblings only");
}

}  // namespace pleura
