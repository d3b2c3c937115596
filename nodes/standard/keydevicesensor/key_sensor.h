#pragma once

#include <pleura/nodes/standard/keydevicesensor/x3d_key_device_sensor_node.h>

namespace pleura {

/// Keys as they go down and up.
class KeySensor : public X3DKeyDeviceSensorNode {
 public:
  SFInt32 actionKeyPress;
  SFInt32 actionKeyRelease;
  SFBool altKey;
  SFBool controlKey;
  SFString keyPress;
  SFString keyRelease;
  SFBool shiftKey;

  static void declare(NodeType& type);

 protected:
  void hear(const KeyEvent& event) override;
};

}  // namespace pleura
