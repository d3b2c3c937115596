#pragma once

#include <pleura/nodes/standard/grouping/x3d_grouping_node.h>

namespace pleura {

/// One of its children, or none.
class Switch : public X3DGroupingNode {
 public:
  SFInt32 whichChoice;

  static void declare(NodeType& type);

 protected:
  std::span<const NodePtr> shown() override;
};

}  // namespace pleura
