#pragma once

#include <pleura/nodes/haptic/force_effect_node.h>

namespace pleura {

/// A spring that catches the tip near its position and lets go when it is pulled away.
class SpringEffect : public ForceEffectNode {
 public:
  SFVec3f position;
  SFFloat springConstant;
  SFFloat damping;
  SFFloat startDistance;
  SFFloat escapeDistance;
  SFVec3f force;
  SFBool active;

  void report(const Vec3f& given, bool isActive) override;

  static void declare(NodeType& type);

 protected:
  haptics::ForceEffect::Kind kindOf(const Matrix4f& toWorld) override;
};

}  // namespace pleura
