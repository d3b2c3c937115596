#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/eventutilities/boolean_toggle.h>

namespace pleura {

void BooleanToggle::declare(NodeType& type) {
  Node::declare(type);
  type.named("BooleanToggle", "EventUtilities", 1).means("a value that turns over with every true");
  using enum Access;
  type.field<&BooleanToggle::toggle>("toggle", inputOutput, false).means("turns over with every true");
  type.field<&BooleanToggle::set_boolean>("set_boolean", inputOnly, false).means("the event to react to");
}

void BooleanToggle::onInitialize() { onEvent_.hears(*this, set_boolean); }

void BooleanToggle::hear() {
  if (set_boolean.getValue(id)) toggle.setValue(!toggle.getValue());
}

}  // namespace pleura
