#pragma once

#include <pleura/nodes/core/event_handler.h>
#include <pleura/nodes/standard/eventutilities/x3d_trigger_node.h>

namespace pleura {

/// A number for every true.
class IntegerTrigger : public X3DTriggerNode {
 public:
  SFInt32 integerKey;
  SFBool set_boolean;
  SFInt32 triggerValue;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  void hear();
  EventHandler onEvent_{[this] { hear(); }};
};

}  // namespace pleura
