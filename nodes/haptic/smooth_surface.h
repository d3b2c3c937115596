#pragma once

#include <pleura/nodes/haptic/haptic_surface_node.h>

namespace pleura {

/// A surface without friction, as wet ice.
class SmoothSurface : public HapticSurfaceNode {
 public:
  static void declare(NodeType& type);
};

}  // namespace pleura
