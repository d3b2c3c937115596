#pragma once

#include <pleura/nodes/standard/interpolation/x3d_interpolator_node.h>

namespace pleura {

/// Positions along a polyline of keys.
class PositionInterpolator : public X3DInterpolatorNode {
 public:
  MFVec3f keyValue;
  SFVec3f value_changed;

  static void declare(NodeType& type);
};

}  // namespace pleura
