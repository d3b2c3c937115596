#pragma once

#include <pleura/nodes/core/event_handler.h>
#include <pleura/nodes/standard/eventutilities/x3d_trigger_node.h>

namespace pleura {

/// The time of every event.
class TimeTrigger : public X3DTriggerNode {
 public:
  SFBool set_boolean;
  SFTime triggerTime;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  void hear();
  EventHandler onEvent_{[this] { hear(); }};
};

}  // namespace pleura
