#include <Eigen/Geometry>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/force_field.h>

namespace pleura {

void ForceField::declare(NodeType& type) {
  ForceEffectNode::declare(type);
  type.named("ForceField", "Pleura").means("a force on the hand, the same everywhere");
  using enum Access;
  type.field<&ForceField::force>("force", inputOutput, Vec3f::Zero())
      .measuredIn(Unit::force)
      .means("the force");
}

haptics::ForceEffect::Kind ForceField::kindOf(const Matrix4f& toWorld) {
  const Vec3f turned = Eigen::Affine3f(toWorld).rotation() * force.getValue();
  return haptics::ConstantForce{turned.cast<double>()};
}

}  // namespace pleura
