#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/keydevicesensor/key_sensor.h>

namespace pleura {

void KeySensor::declare(NodeType& type) {
  X3DSensorNode::declare(type);
  type.named("KeySensor", "KeyDeviceSensor", 1).means("keys as they go down and up");
  using enum Access;
  type.field<&KeySensor::actionKeyPress>("actionKeyPress", outputOnly, 0)
      .means("number of the action key that went down");
  type.field<&KeySensor::actionKeyRelease>("actionKeyRelease", outputOnly, 0)
      .means("number of the action key that went up");
  type.field<&KeySensor::altKey>("altKey", outputOnly, false).means("whether Alt is down");
  type.field<&KeySensor::controlKey>("controlKey", outputOnly, false).means("whether Control is down");
  type.field<&KeySensor::keyPress>("keyPress", outputOnly, {}).means("character of the key that went down");
  type.field<&KeySensor::keyRelease>("keyRelease", outputOnly, {}).means("character of the key that went up");
  type.field<&KeySensor::shiftKey>("shiftKey", outputOnly, false).means("whether Shift is down");
}

void KeySensor::hear(const KeyEvent& event) {
  isActive.setValueIfChanged(event.pressed, id);
  switch (event.kind) {
    case KeyEvent::Kind::character:
      return (event.pressed ? keyPress : keyRelease).setValue(event.character, id);
    case KeyEvent::Kind::action:
      return (event.pressed ? actionKeyPress : actionKeyRelease).setValue(event.action, id);
    case KeyEvent::Kind::shift:
      return shiftKey.setValue(event.pressed, id);
    case KeyEvent::Kind::control:
      return controlKey.setValue(event.pressed, id);
    case KeyEvent::Kind::alt:
      return altKey.setValue(event.pressed, id);
  }
}

}  // namespace pleura
