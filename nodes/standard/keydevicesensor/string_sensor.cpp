#include <utility>

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

void StringSensor::hear(const KeyEvent& event) {
  if (event.kind != KeyEvent::Kind::character || !event.pressed) return;
  if (event.character == "\r" || event.character == "\n") {
    finalText.setValue(std::exchange(text_, {}), id);
    enteredText.setValue(text_, id);
    isActive.setValueIfChanged(false, id);
    return;
  }
  if (event.character == "\b" || event.character == "\x7f") {
    if (!deletionAllowed.getValue() || text_.empty()) return;
    const auto isContinuation = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
    while (text_.size() > 1 && isContinuation(text_.back())) text_.pop_back();
    text_.pop_back();
  } else {
    text_ += event.character;
  }
  isActive.setValueIfChanged(true, id);
  enteredText.setValue(text_, id);
}

}  // namespace pleura
