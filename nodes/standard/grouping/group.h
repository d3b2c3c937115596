#pragma once

#include <pleura/nodes/standard/grouping/x3d_grouping_node.h>

namespace pleura {

/// Children in order.
class Group : public X3DGroupingNode {
 public:
  static void declare(NodeType& type);
};

}  // namespace pleura
