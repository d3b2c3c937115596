#pragma once

#include <pleura/nodes/standard/environmental_effects/x3d_background_node.h>

namespace pleura {

/// Sky, ground and panorama.
class Background : public X3DBackgroundNode {
 public:
  MFString backUrl;
  MFString bottomUrl;
  MFString frontUrl;
  MFString leftUrl;
  MFString rightUrl;
  MFString topUrl;

  static void declare(NodeType& type);
};

}  // namespace pleura
