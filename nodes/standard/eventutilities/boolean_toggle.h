#pragma once

#include <pleura/nodes/core/event_handler.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// A value that turns over with every true.
class BooleanToggle : public X3DChildNode {
 public:
  SFBool toggle;
  SFBool set_boolean;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  void hear();
  EventHandler onEvent_{[this] { hear(); }};
};

}  // namespace pleura
