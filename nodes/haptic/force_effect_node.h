#pragma once

#include <optional>

#include <pleura/haptics/servo/force_effect.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// A force on the hand that comes of no surface (H3DForceEffect), in the frame of the group it stands in.
class ForceEffectNode : public X3DChildNode {
 public:
  SFBool enabled;

  /// The force as the haptic loop takes it; `toWorld` is of the group it stands in. Nothing while it has
  /// none.
  std::optional<haptics::ForceEffect> effect(const Matrix4f& toWorld);
  /// What the loop tells of it: the force on the hand in the scene, and whether a spring holds it.
  virtual void report(const Vec3f& given, bool isActive);

  static void declare(NodeType& type);

 protected:
  virtual haptics::ForceEffect::Kind kindOf(const Matrix4f& toWorld) = 0;
};

}  // namespace pleura
