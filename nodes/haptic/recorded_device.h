#pragma once

#include <pleura/nodes/haptic/haptics_device_node.h>

namespace pleura {

/// A session that was recorded, played again.
class RecordedDevice : public HapticsDeviceNode {
 public:
  MFString url;

  std::vector<std::string> drivers() const override { return {"recorded"}; }
  std::string file() override;

  static void declare(NodeType& type);
};

}  // namespace pleura
