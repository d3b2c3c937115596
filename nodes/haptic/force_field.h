#pragma once

#include <pleura/nodes/haptic/force_effect_node.h>

namespace pleura {

/// A force that is the same everywhere.
class ForceField : public ForceEffectNode {
 public:
  SFVec3f force;

  static void declare(NodeType& type);

 protected:
  haptics::ForceEffect::Kind kindOf(const Matrix4f& toWorld) override;
};

}  // namespace pleura
