#pragma once

#include <pleura/nodes/core/event_handler.h>
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

 protected:
  void onInitialize() override;

 private:
  void hear();
  EventHandler onEvent_{[this] { hear(); }};
};

}  // namespace pleura
