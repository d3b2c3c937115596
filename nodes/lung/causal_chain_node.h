#pragma once

#include <pleura/fields/typed_field.h>
#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/lung/causality/causal_chain.h>
#include <pleura/nodes/lung/pleural_space.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// Tells what in a breath rises, falls or stands at this moment, and because of what, from muscle force to
/// air flow (causality/causal_chain.h).
class CausalChainNode : public X3DChildNode {
 public:
  TypedSFNode<PleuralSpace> space;

  class Text : public TypedField<MFString, AnyNumber<SFTime>> {
    void update() override;
  };
  Text text;

  class Change : public TypedField<MFInt32, AnyNumber<SFTime>> {
    void update() override;
  };
  Change change;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  CausalChain now();
};

}  // namespace pleura
