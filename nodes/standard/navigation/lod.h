#pragma once

#include <pleura/nodes/standard/grouping/x3d_grouping_node.h>

namespace pleura {

/// One child, by its distance from the viewer.
class LOD : public X3DGroupingNode {
 public:
  SFVec3f center;
  SFBool forceTransitions;
  MFFloat range;
  SFInt32 level_changed;

  static void declare(NodeType& type);
};

}  // namespace pleura
