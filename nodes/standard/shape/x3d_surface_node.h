#pragma once

#include <pleura/nodes/standard/shape/x3d_appearance_child_node.h>

namespace pleura {

/// How a shape feels (H3DSurfaceNode): what makes it touchable at all.
class X3DSurfaceNode : public X3DAppearanceChildNode {
 public:
  /// Whether a shape that can deform gives way where it is touched.
  virtual bool givesWay() const { return false; }
};

}  // namespace pleura
