#pragma once

#include <pleura/nodes/core/event_handler.h>
#include <pleura/nodes/standard/eventutilities/x3d_trigger_node.h>

namespace pleura {

/// True for every time.
class BooleanTrigger : public X3DTriggerNode {
 public:
  SFTime set_triggerTime;
  SFBool triggerTrue;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  void hear();
  EventHandler onEvent_{[this] { hear(); }};
};

}  // namespace pleura
