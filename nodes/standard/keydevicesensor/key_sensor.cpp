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

}  // namespace pleura
