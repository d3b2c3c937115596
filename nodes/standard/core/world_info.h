#pragma once

#include <pleura/nodes/standard/core/x3d_info_node.h>

namespace pleura {

/// Title of the scene and words about it.
class WorldInfo : public X3DInfoNode {
 public:
  MFString info;
  SFString title;

  static void declare(NodeType& type);
};

}  // namespace pleura
