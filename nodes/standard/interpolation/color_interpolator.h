#pragma once

#include <pleura/nodes/standard/interpolation/x3d_interpolator_node.h>

namespace pleura {

/// Colours between keys, in hue, saturation and value.
class ColorInterpolator : public X3DInterpolatorNode {
 public:
  MFColor keyValue;
  SFColor value_changed;

  static void declare(NodeType& type);
};

}  // namespace pleura
