#pragma once

#include <pleura/nodes/standard/core/x3d_bindable_node.h>

namespace pleura {

/// What is seen behind everything.
class X3DBackgroundNode : public X3DBindableNode {
 public:
  MFFloat groundAngle;
  MFColor groundColor;
  MFFloat skyAngle;
  MFColor skyColor;
  SFFloat transparency;

  static void declare(NodeType& type);

 protected:
  std::string_view kind() const override { return "Background"; }
};

}  // namespace pleura
