#include <numbers>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/viscosity_effect.h>

namespace pleura {

void ViscosityEffect::declare(NodeType& type) {
  ForceEffectNode::declare(type);
  type.named("ViscosityEffect", "Pleura").means("drag on the hand, as of a ball in a fluid");
  using enum Access;
  type.field<&ViscosityEffect::viscosity>("viscosity", inputOutput, 0.015f)
      .atLeast(0)
      .means("dynamic viscosity of the fluid [Pa s]");
  type.field<&ViscosityEffect::radius>("radius", inputOutput, 0.0025f)
      .measuredIn(Unit::length)
      .atLeast(0)
      .means("of the ball");
  type.field<&ViscosityEffect::dampingFactor>("dampingFactor", inputOutput, 0.6f)
      .atLeast(0)
      .means("times the force");
  type.field<&ViscosityEffect::force>("force", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::force)
      .means("on the hand, in the scene");
}

haptics::ForceEffect::Kind ViscosityEffect::kindOf(const Matrix4f&) {
  // F = -6 pi eta r v (Stokes 1851)
  return haptics::ViscousForce{6 * std::numbers::pi * viscosity.getValue() * radius.getValue() *
                               dampingFactor.getValue()};
}

void ViscosityEffect::report(const Vec3f& given, bool) { force.setValueIfChanged(given, id); }

}  // namespace pleura
