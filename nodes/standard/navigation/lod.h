#pragma once

#include <pleura/nodes/standard/grouping/x3d_grouping_node.h>

namespace pleura {

/// One child, by its distance d from the viewer: number i where range[i - 1] <= d < range[i], the last where
/// there are not so many (X3D 23.4.3). The first until the viewer is known.
class LOD : public X3DGroupingNode {
 public:
  SFVec3f center;
  SFBool forceTransitions;
  MFFloat range;
  SFInt32 level_changed;

  /// Chooses the child for a viewer at that place [m] of the node's own frame.
  void seeFrom(const Vec3f& viewer);

  static void declare(NodeType& type);

 protected:
  std::span<const NodePtr> shown() override;
};

}  // namespace pleura
