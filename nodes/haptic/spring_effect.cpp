#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/spring_effect.h>

namespace pleura {

void SpringEffect::declare(NodeType& type) {
  ForceEffectNode::declare(type);
  type.named("SpringEffect", "Pleura").means("a spring that catches the tip of a haptic device");
  using enum Access;
  type.field<&SpringEffect::position>("position", inputOutput, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("where it pulls to");
  type.field<&SpringEffect::springConstant>("springConstant", inputOutput, 100)
      .atLeast(0)
      .means("force per distance [N/m]; no more than the device holds stably is given");
  type.field<&SpringEffect::damping>("damping", inputOutput, 0).atLeast(0).means("force per speed [N s/m]");
  type.field<&SpringEffect::startDistance>("startDistance", inputOutput, 0.01f)
      .measuredIn(Unit::length)
      .atLeast(0)
      .means("from which it catches");
  type.field<&SpringEffect::escapeDistance>("escapeDistance", inputOutput, 0.01f)
      .measuredIn(Unit::length)
      .atLeast(0)
      .means("beyond which it lets go");
  type.field<&SpringEffect::force>("force", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::force)
      .means("on the hand, in the scene");
  type.field<&SpringEffect::active>("active", outputOnly, false).means("whether it holds the tip");
}

haptics::ForceEffect::Kind SpringEffect::kindOf(const Matrix4f& toWorld) {
  const Vec3f at = toWorld.topLeftCorner<3, 3>() * position.getValue() + toWorld.topRightCorner<3, 1>();
  return haptics::SpringForce{.position = at.cast<double>(),
                              .stiffness = springConstant.getValue(),
                              .damping = damping.getValue(),
                              .startDistance = startDistance.getValue(),
                              .escapeDistance = escapeDistance.getValue()};
}

void SpringEffect::report(const Vec3f& given, bool isActive) {
  force.setValueIfChanged(given, id);
  active.setValueIfChanged(isActive, id);
}

}  // namespace pleura
