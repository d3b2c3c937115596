#pragma once

#include <pleura/nodes/standard/lighting/x3d_light_node.h>

namespace pleura {

/// Light from a point to all sides.
class PointLight : public X3DLightNode {
 public:
  SFVec3f attenuation;
  SFBool global;
  SFVec3f location;
  SFFloat radius;

  static void declare(NodeType& type);
};

}  // namespace pleura
