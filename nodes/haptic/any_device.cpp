#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/any_device.h>

namespace pleura {

void AnyDevice::declare(NodeType& type) {
  HapticsDeviceNode::declare(type);
  type.named("AnyDevice", "Pleura")
      .means("whatever haptic device there is, a simulated one where there is none");
}

}  // namespace pleura
