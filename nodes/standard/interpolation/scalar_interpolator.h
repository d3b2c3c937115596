#pragma once

#include <pleura/nodes/standard/interpolation/x3d_interpolator_node.h>

namespace pleura {

/// Numbers along a polyline of keys.
class ScalarInterpolator : public X3DInterpolatorNode {
 public:
  MFFloat keyValue;
  SFFloat value_changed;

  static void declare(NodeType& type);
};

}  // namespace pleura
