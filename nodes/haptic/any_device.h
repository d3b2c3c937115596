#pragma once

#include <pleura/nodes/haptic/haptics_device_node.h>

namespace pleura {

/// Whatever device there is: a Phantom, else a simulated one that rests at the origin.
class AnyDevice : public HapticsDeviceNode {
 public:
  std::vector<std::string> drivers() const override { return {"phantom", "simulated"}; }

  static void declare(NodeType& type);
};

}  // namespace pleura
