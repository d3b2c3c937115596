#pragma once

#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// A source of light.
class X3DLightNode : public X3DChildNode {
 public:
  SFFloat ambientIntensity;
  SFColor color;
  SFFloat intensity;
  SFBool on;
  SFFloat shadowIntensity;
  SFBool shadows;

  static void declare(NodeType& type);
};

}  // namespace pleura
