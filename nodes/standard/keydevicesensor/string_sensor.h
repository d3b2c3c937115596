#pragma once

#include <pleura/nodes/standard/keydevicesensor/x3d_key_device_sensor_node.h>

namespace pleura {

/// Text as it is typed: Enter ends it, Backspace takes the last character back.
class StringSensor : public X3DKeyDeviceSensorNode {
 public:
  SFBool deletionAllowed;
  SFString enteredText;
  SFString finalText;

  static void declare(NodeType& type);

 protected:
  void hear(const KeyEvent& event) override;

 private:
  std::string text_;
};

}  // namespace pleura
