#pragma once

#include <pleura/nodes/haptic/force_effect_node.h>

namespace pleura {

/// Drag as of a ball in a fluid (Stokes).
class ViscosityEffect : public ForceEffectNode {
 public:
  SFFloat viscosity;
  SFFloat radius;
  SFFloat dampingFactor;
  SFVec3f force;

  void report(const Vec3f& given, bool isActive) override;

  static void declare(NodeType& type);

 protected:
  haptics::ForceEffect::Kind kindOf(const Matrix4f& toWorld) override;
};

}  // namespace pleura
