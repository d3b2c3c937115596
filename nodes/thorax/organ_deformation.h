#pragma once

#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/deformable/deformer_node.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>
#include <pleura/nodes/thorax/contacts_node.h>

namespace pleura {

/// Chooses how an organ deforms, one that stands in another file included: only what a wall touches is moved
/// by it, the rest by this deformer.
class OrganDeformation : public X3DChildNode {
 public:
  TypedSFNode<ContactsNode> contacts;
  TypedSFNode<DeformerNode> deformer;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;
};

}  // namespace pleura
