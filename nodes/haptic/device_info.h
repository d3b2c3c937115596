#pragma once

#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/haptic/haptics_device_node.h>
#include <pleura/nodes/standard/core/x3d_bindable_node.h>

namespace pleura {

/// The haptic devices of a scene; the bound one's are in use.
class DeviceInfo : public X3DBindableNode {
 public:
  TypedMFNode<HapticsDeviceNode> device;

  static void declare(NodeType& type);

 protected:
  std::string_view kind() const override { return "DeviceInfo"; }
};

}  // namespace pleura
