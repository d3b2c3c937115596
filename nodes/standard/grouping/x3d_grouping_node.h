#pragma once

#include <pleura/nodes/core/event_handler.h>
#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>
#include <pleura/nodes/standard/grouping/x3d_bounded_object.h>

namespace pleura {

/// A node with children. Nodes sent to addChildren join them unless they are there, nodes sent to
/// removeChildren leave them.
class X3DGroupingNode : public X3DChildNode, public X3DBoundedObject {
 public:
  TypedMFNode<X3DChildNode> children;
  TypedMFNode<X3DChildNode> addChildren;
  TypedMFNode<X3DChildNode> removeChildren;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;
  std::span<const NodePtr> shown() override { return children.getValue(); }

 private:
  void changeChildren();
  EventHandler onChildren_{[this] { changeChildren(); }};
};

}  // namespace pleura
