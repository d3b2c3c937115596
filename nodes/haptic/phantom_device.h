#pragma once

#include <pleura/nodes/haptic/haptics_device_node.h>

namespace pleura {

/// A Phantom-class device, driven through its vendor's library where that is installed.
class PhantomDevice : public HapticsDeviceNode {
 public:
  SFString deviceName;

  std::vector<std::string> drivers() const override { return {"phantom"}; }
  haptics::DeviceSettings settings() override;

  static void declare(NodeType& type);
};

}  // namespace pleura
