#pragma once

#include <pleura/nodes/standard/lighting/x3d_light_node.h>

namespace pleura {

/// Light from a point into a cone.
class SpotLight : public X3DLightNode {
 public:
  SFVec3f attenuation;
  SFFloat beamWidth;
  SFFloat cutOffAngle;
  SFVec3f direction;
  SFBool global;
  SFVec3f location;
  SFFloat radius;

  static void declare(NodeType& type);
};

}  // namespace pleura
