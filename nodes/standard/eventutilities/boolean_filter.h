#pragma once

#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// Sorts true from false.
class BooleanFilter : public X3DChildNode {
 public:
  SFBool set_boolean;
  SFBool inputFalse;
  SFBool inputNegate;
  SFBool inputTrue;

  static void declare(NodeType& type);
};

}  // namespace pleura
