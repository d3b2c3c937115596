#pragma once

#include <pleura/nodes/standard/keydevicesensor/x3d_key_device_sensor_node.h>

namespace pleura {

/// Text as it is typed.
class StringSensor : public X3DKeyDeviceSensorNode {
 public:
  SFBool deletionAllowed;
  SFString enteredText;
  SFString finalText;

  static void declare(NodeType& type);
};

}  // namespace pleura
