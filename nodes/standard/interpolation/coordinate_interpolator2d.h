#pragma once

#include <pleura/nodes/standard/interpolation/x3d_interpolator_node.h>

namespace pleura {

/// Lists of points in a plane between keys.
class CoordinateInterpolator2D : public X3DInterpolatorNode {
 public:
  MFVec2f keyValue;
  MFVec2f value_changed;

  static void declare(NodeType& type);
};

}  // namespace pleura
