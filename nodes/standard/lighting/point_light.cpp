#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/lighting/point_light.h>

namespace pleura {

void PointLight::declare(NodeType& type) {
  X3DLightNode::declare(type);
  type.named("PointLight", "Lighting", 2).means("light from a point to all sides");
  using enum Access;
  type.field<&PointLight::attenuation>("attenuation", inputOutput, Vec3f(1, 0, 0))
      .atLeast(0)
      .means("factors of 1, distance and its square in the loss");
  type.field<&PointLight::global>("global", inputOutput, true)
      .means("whether it lights the whole scene, or its siblings only");
  type.field<&PointLight::location>("location", inputOutput, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("where the light stands");
  type.field<&PointLight::radius>("radius", inputOutput, 100)
      .measuredIn(Unit::length)
      .atLeast(0)
      .means("distance beyond which nothing is lit");
}

}  // namespace pleura
