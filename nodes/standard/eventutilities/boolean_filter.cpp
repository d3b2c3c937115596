#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/eventutilities/boolean_filter.h>

namespace pleura {

void BooleanFilter::declare(NodeType& type) {
  Node::declare(type);
  type.named("BooleanFilter", "EventUtilities", 1).means("sorts true from false");
  using enum Access;
  type.field<&BooleanFilter::set_boolean>("set_boolean", inputOnly, false).means("the event to react to");
  type.field<&BooleanFilter::inputFalse>("inputFalse", outputOnly, false).means("sent for every false");
  type.field<&BooleanFilter::inputNegate>("inputNegate", outputOnly, false)
      .means("the contrary of every value");
  type.field<&BooleanFilter::inputTrue>("inputTrue", outputOnly, false).means("sent for every true");
}

void BooleanFilter::onInitialize() { onEvent_.hears(*this, set_boolean); }

void BooleanFilter::hear() {
  const bool value = set_boolean.getValue(id);
  (value ? inputTrue : inputFalse).setValue(value, id);
  inputNegate.setValue(!value, id);
}

}  // namespace pleura
