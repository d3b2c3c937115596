#pragma once

#include <pleura/nodes/haptic/frictional_surface.h>

namespace pleura {

/// The surface of something soft: where it is touched it gives way, as is felt so it is seen.
class TissueSurface : public FrictionalSurface {
 public:
  bool givesWay() const override { return true; }

  static void declare(NodeType& type);
};

}  // namespace pleura
