#pragma once

#include <pleura/nodes/standard/grouping/x3d_grouping_node.h>

namespace pleura {

/// Children that turn to the viewer.
class Billboard : public X3DGroupingNode {
 public:
  SFVec3f axisOfRotation;

  static void declare(NodeType& type);
};

}  // namespace pleura
