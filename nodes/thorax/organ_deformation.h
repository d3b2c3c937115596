#pragma once

#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/deformable/deformer_node.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>
#include <pleura/nodes/thorax/contacts_node.h>

namespace pleura {

/// Chooses how an organ deforms, one that stands in another file included: only what a wall touches is moved
/// by it, the rest by this deformer. Without one, the cheapest that was measured to be within `tolerance` and
/// `budget` on this machine.
class OrganDeformation : public X3DChildNode {
 public:
  TypedSFNode<ContactsNode> contacts;
  TypedSFNode<DeformerNode> deformer;
  SFFloat tolerance;
  SFFloat budget;

  SFString chosen;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  /// Null where the smooth fill does, or where nothing does, which is told.
  NodePtr choose(DeformableShape2& organ);
  NodePtr made(const DeformationFigure& figure);
};

}  // namespace pleura
