#pragma once

#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>
#include <pleura/nodes/standard/grouping/x3d_grouping_node.h>

namespace pleura {

/// Children that the viewer may bump into.
class Collision : public X3DGroupingNode {
 public:
  SFString description;
  SFBool enabled;
  TypedSFNode<X3DChildNode> proxy;
  SFTime collideTime;
  SFBool isActive;

  static void declare(NodeType& type);
};

}  // namespace pleura
