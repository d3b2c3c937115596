#pragma once

#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// Viewpoints that belong together.
class ViewpointGroup : public X3DChildNode {
 public:
  SFVec3f center;
  MFNode children;
  SFString description;
  SFBool displayed;
  SFBool retainUserOffsets;
  SFVec3f size;

  static void declare(NodeType& type);
};

}  // namespace pleura
