#pragma once

#include <pleura/nodes/standard/interpolation/x3d_interpolator_node.h>

namespace pleura {

/// Lists of normals between keys, on the unit sphere.
class NormalInterpolator : public X3DInterpolatorNode {
 public:
  MFVec3f keyValue;
  MFVec3f value_changed;

  static void declare(NodeType& type);
};

}  // namespace pleura
