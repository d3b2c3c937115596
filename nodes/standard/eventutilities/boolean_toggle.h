#pragma once

#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// A value that turns over with every true.
class BooleanToggle : public X3DChildNode {
 public:
  SFBool toggle;
  SFBool set_boolean;

  static void declare(NodeType& type);
};

}  // namespace pleura
