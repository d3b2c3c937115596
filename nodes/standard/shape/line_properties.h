#pragma once

#include <pleura/nodes/standard/shape/x3d_appearance_child_node.h>

namespace pleura {

/// How lines are drawn.
class LineProperties : public X3DAppearanceChildNode {
 public:
  SFBool applied;
  SFInt32 linetype;
  SFFloat linewidthScaleFactor;

  static void declare(NodeType& type);
};

}  // namespace pleura
