#pragma once

#include <pleura/nodes/standard/grouping/x3d_grouping_node.h>
#include <pleura/nodes/standard/networking/x3d_url_object.h>

namespace pleura {

/// Children that lead somewhere when clicked.
class Anchor : public X3DGroupingNode, public X3DUrlObject {
 public:
  MFString parameter;

  static void declare(NodeType& type);
};

}  // namespace pleura
