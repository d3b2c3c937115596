#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/standard/eventutilities/time_trigger.h>

namespace pleura {

void TimeTrigger::declare(NodeType& type) {
  Node::declare(type);
  type.named("TimeTrigger", "EventUtilities", 1).means("the time of every event");
  using enum Access;
  type.field<&TimeTrigger::set_boolean>("set_boolean", inputOnly, false).means("the event to react to");
  type.field<&TimeTrigger::triggerTime>("triggerTime", outputOnly, 0)
      .measuredIn(Unit::time)
      .means("when an event came");
}

void TimeTrigger::onInitialize() { onEvent_.hears(*this, set_boolean); }

void TimeTrigger::hear() { triggerTime.setValue(context().time.getValue(), id); }

}  // namespace pleura
