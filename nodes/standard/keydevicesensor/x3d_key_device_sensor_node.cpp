#include <pleura/nodes/standard/keydevicesensor/x3d_key_device_sensor_node.h>

namespace pleura {

X3DKeyDeviceSensorNode::~X3DKeyDeviceSensorNode() {
  if (isInitialized()) context().removeKeyListener(this);
}

void X3DKeyDeviceSensorNode::onInitialize() {
  context().addKeyListener(this);
  onEnabled_.hears(*this, enabled);
}

void X3DKeyDeviceSensorNode::onKey(const KeyEvent& event) {
  if (enabled.getValue()) hear(event);
}

}  // namespace pleura
