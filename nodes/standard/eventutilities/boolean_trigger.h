#pragma once

#include <pleura/nodes/standard/eventutilities/x3d_trigger_node.h>

namespace pleura {

/// True for every time.
class BooleanTrigger : public X3DTriggerNode {
 public:
  SFTime set_triggerTime;
  SFBool triggerTrue;

  static void declare(NodeType& type);
};

}  // namespace pleura
