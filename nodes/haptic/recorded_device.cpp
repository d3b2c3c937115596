#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/recorded_device.h>

namespace pleura {

void RecordedDevice::declare(NodeType& type) {
  HapticsDeviceNode::declare(type);
  type.named("RecordedDevice", "Pleura").means("a recorded session of a haptic device, played again");
  using enum Access;
  type.field<&RecordedDevice::url>("url", initializeOnly, {}).means("the recording");
}

std::string RecordedDevice::file() {
  const auto& urls = url.getValue(id);
  return urls.empty() ? std::string() : urls.front();
}

}  // namespace pleura
