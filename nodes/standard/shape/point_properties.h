#pragma once

#include <pleura/nodes/standard/shape/x3d_appearance_child_node.h>

namespace pleura {

/// How points are drawn.
class PointProperties : public X3DAppearanceChildNode {
 public:
  SFVec3f attenuation;
  SFFloat pointSizeMaxValue;
  SFFloat pointSizeMinValue;
  SFFloat pointSizeScaleFactor;

  static void declare(NodeType& type);
};

}  // namespace pleura
