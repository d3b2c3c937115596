#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/eventutilities/boolean_sequencer.h>

namespace pleura {

void BooleanSequencer::declare(NodeType& type) {
  X3DSequencerNode::declare(type);
  type.named("BooleanSequencer", "EventUtilities", 1).means("booleans step by step");
  using enum Access;
  type.field<&BooleanSequencer::keyValue>("keyValue", inputOutput, {})
      .means("the values at the keys, in order");
  type.field<&BooleanSequencer::value_changed>("value_changed", outputOnly, false)
      .means("the value at the fraction");
}

}  // namespace pleura
