#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/phantom_device.h>

namespace pleura {

void PhantomDevice::declare(NodeType& type) {
  HapticsDeviceNode::declare(type);
  type.named("PhantomDevice", "Pleura").means("a Phantom: Touch, Omni, Desktop, Premium");
  using enum Access;
  type.field<&PhantomDevice::deviceName>("deviceName", initializeOnly, "")
      .means("as it is configured with its vendor's tools; empty: the default device");
}

haptics::DeviceSettings PhantomDevice::settings() { return {.model = deviceName.getValue(id)}; }

}  // namespace pleura
