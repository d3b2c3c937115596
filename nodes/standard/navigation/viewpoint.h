#pragma once

#include <pleura/nodes/standard/navigation/x3d_viewpoint_node.h>

namespace pleura {

/// A place to look from, in perspective.
class Viewpoint : public X3DViewpointNode {
 public:
  SFVec3f centerOfRotation;
  SFFloat fieldOfView;
  SFVec3f position;

  static void declare(NodeType& type);
};

}  // namespace pleura
