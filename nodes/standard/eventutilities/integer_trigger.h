#pragma once

#include <pleura/nodes/standard/eventutilities/x3d_trigger_node.h>

namespace pleura {

/// A number for every true.
class IntegerTrigger : public X3DTriggerNode {
 public:
  SFInt32 integerKey;
  SFBool set_boolean;
  SFInt32 triggerValue;

  static void declare(NodeType& type);
};

}  // namespace pleura
