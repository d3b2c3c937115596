#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/smooth_surface.h>

namespace pleura {

void SmoothSurface::declare(NodeType& type) {
  HapticSurfaceNode::declare(type);
  type.named("SmoothSurface", "Pleura").means("feels hard and without friction");
}

}  // namespace pleura
