#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/eventutilities/integer_trigger.h>

namespace pleura {

void IntegerTrigger::declare(NodeType& type) {
  Node::declare(type);
  type.named("IntegerTrigger", "EventUtilities", 1).means("a number for every true");
  using enum Access;
  type.field<&IntegerTrigger::integerKey>("integerKey", inputOutput, -1).means("the number to send");
  type.field<&IntegerTrigger::set_boolean>("set_boolean", inputOnly, false).means("the event to react to");
  type.field<&IntegerTrigger::triggerValue>("triggerValue", outputOnly, 0)
      .means("integerKey, for every true");
}

void IntegerTrigger::onInitialize() { onEvent_.hears(*this, set_boolean); }

void IntegerTrigger::hear() {
  if (set_boolean.getValue(id)) triggerValue.setValue(integerKey.getValue(), id);
}

}  // namespace pleura
