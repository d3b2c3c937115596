#pragma once

#include <pleura/nodes/standard/lighting/x3d_light_node.h>

namespace pleura {

/// Light from one direction.
class DirectionalLight : public X3DLightNode {
 public:
  SFVec3f direction;
  SFBool global;

  static void declare(NodeType& type);
};

}  // namespace pleura
