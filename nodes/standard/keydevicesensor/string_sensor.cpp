#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/keydevicesensor/string_sensor.h>

namespace pleura {

void StringSensor::declare(NodeType& type) {
  X3DSensorNode::declare(type);
  type.named("StringSensor", "KeyDeviceSensor", 2).means("text as it is typed");
  using enum Access;
  type.field<&StringSensor::deletionAllowed>("deletionAllowed", inputOutput, true)
      .means("whether Backspace takes characters back");
  type.field<&StringSensor::enteredText>("enteredText", outputOnly, {}).means("the text so far");
  type.field<&StringSensor::finalText>("finalText", outputOnly, {})
      .means("the text, once Enter has ended it");
}

}  // namespace pleura
