#pragma once

#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>
#include <pleura/nodes/standard/grouping/x3d_bounded_object.h>

namespace pleura {

/// Children that never change.
class StaticGroup : public X3DChildNode, public X3DBoundedObject {
 public:
  TypedMFNode<X3DChildNode> children;

  static void declare(NodeType& type);

 protected:
  std::span<const NodePtr> shown() override { return children.getValue(); }
};

}  // namespace pleura
