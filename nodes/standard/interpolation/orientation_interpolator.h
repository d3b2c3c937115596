#pragma once

#include <pleura/nodes/standard/interpolation/x3d_interpolator_node.h>

namespace pleura {

/// Turns from key to key, the shorter way round.
class OrientationInterpolator : public X3DInterpolatorNode {
 public:
  MFRotation keyValue;
  SFRotation value_changed;

  static void declare(NodeType& type);
};

}  // namespace pleura
