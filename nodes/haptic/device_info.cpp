#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/device_info.h>

namespace pleura {

void DeviceInfo::declare(NodeType& type) {
  X3DBindableNode::declare(type);
  type.named("DeviceInfo", "Pleura").means("the haptic devices of a scene");
  using enum Access;
  type.field<&DeviceInfo::device>("device", inputOutput, {}).means("the devices");
}

}  // namespace pleura
