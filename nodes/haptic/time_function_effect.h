#pragma once

#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/haptic/force_effect_node.h>
#include <pleura/nodes/haptic/sine_function.h>

namespace pleura {

/// A force that changes with time, each axis in its own way.
class TimeFunctionEffect : public ForceEffectNode {
 public:
  TypedSFNode<SineFunction> xFunction;
  TypedSFNode<SineFunction> yFunction;
  TypedSFNode<SineFunction> zFunction;

  static void declare(NodeType& type);

 protected:
  haptics::ForceEffect::Kind kindOf(const Matrix4f& toWorld) override;
};

}  // namespace pleura
