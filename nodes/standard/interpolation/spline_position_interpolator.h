#pragma once

#include <pleura/nodes/standard/interpolation/x3d_interpolator_node.h>

namespace pleura {

/// Positions along a smooth curve through the keys.
class SplinePositionInterpolator : public X3DInterpolatorNode {
 public:
  SFBool closed;
  MFVec3f keyValue;
  MFVec3f keyVelocity;
  SFBool normalizeVelocity;
  SFVec3f value_changed;

  static void declare(NodeType& type);
};

}  // namespace pleura
