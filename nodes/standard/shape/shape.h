#pragma once

#include <pleura/nodes/standard/shape/x3d_shape_node.h>

namespace pleura {

/// A geometry and how it looks.
class Shape : public X3DShapeNode {
 public:
  static void declare(NodeType& type);
};

}  // namespace pleura
