#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/eventutilities/boolean_trigger.h>

namespace pleura {

void BooleanTrigger::declare(NodeType& type) {
  Node::declare(type);
  type.named("BooleanTrigger", "EventUtilities", 1).means("true for every time");
  using enum Access;
  type.field<&BooleanTrigger::set_triggerTime>("set_triggerTime", inputOnly, 0)
      .measuredIn(Unit::time)
      .means("the event to react to");
  type.field<&BooleanTrigger::triggerTrue>("triggerTrue", outputOnly, false).means("true for every event");
}

void BooleanTrigger::onInitialize() { onEvent_.hears(*this, set_triggerTime); }

void BooleanTrigger::hear() { triggerTrue.setValue(true, id); }

}  // namespace pleura
