#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/lighting/spot_light.h>

namespace pleura {

void SpotLight::declare(NodeType& type) {
  X3DLightNode::declare(type);
  type.named("SpotLight", "Lighting", 2).means("light from a point into a cone");
  using enum Access;
  type.field<&SpotLight::attenuation>("attenuation", inputOutput, Vec3f(1, 0, 0))
      .atLeast(0)
      .means("factors of 1, distance and its square in the loss");
  type.field<&SpotLight::beamWidth>("beamWidth", inputOutput, 0.589049f)
      .measuredIn(Unit::angle)
      .positive(1.5708)
      .means("angle from the axis up to which the light is full");
  type.field<&SpotLight::cutOffAngle>("cutOffAngle", inputOutput, 1.570796f)
      .measuredIn(Unit::angle)
      .positive(1.5708)
      .means("angle from the axis beyond which nothing is lit");
  type.field<&SpotLight::direction>("direction", inputOutput, Vec3f(0, 0, -1)).means("where the light goes");
  type.field<&SpotLight::global>("global", inputOutput, true)
      .means("whether it lights the whole scene, or its siblings only");
  type.field<&SpotLight::location>("location", inputOutput, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("where the light stands");
  type.field<&SpotLight::radius>("radius", inputOutput, 100)
      .measuredIn(Unit::length)
      .atLeast(0)
      .means("distance beyond which nothing is lit");
}

}  // namespace pleura
