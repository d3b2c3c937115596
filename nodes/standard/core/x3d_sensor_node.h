#pragma once

#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// A node that turns what happens outside the scene into events.
class X3DSensorNode : public X3DChildNode {
 public:
  SFString description;
  SFBool enabled;
  SFBool isActive;

  static void declare(NodeType& type);
};

}  // namespace pleura
