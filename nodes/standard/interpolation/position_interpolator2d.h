#pragma once

#include <pleura/nodes/standard/interpolation/x3d_interpolator_node.h>

namespace pleura {

/// Positions in a plane along a polyline of keys.
class PositionInterpolator2D : public X3DInterpolatorNode {
 public:
  MFVec2f keyValue;
  SFVec2f value_changed;

  static void declare(NodeType& type);
};

}  // namespace pleura
