#pragma once

#include <pleura/nodes/standard/interpolation/x3d_interpolator_node.h>

namespace pleura {

/// Numbers along a smooth curve through the keys.
class SplineScalarInterpolator : public X3DInterpolatorNode {
 public:
  SFBool closed;
  MFFloat keyValue;
  MFFloat keyVelocity;
  SFBool normalizeVelocity;
  SFFloat value_changed;

  static void declare(NodeType& type);
};

}  // namespace pleura
