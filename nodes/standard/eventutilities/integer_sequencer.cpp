#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/eventutilities/integer_sequencer.h>

namespace pleura {

void IntegerSequencer::declare(NodeType& type) {
  X3DSequencerNode::declare(type);
  type.named("IntegerSequencer", "EventUtilities", 1).means("whole numbers step by step");
  using enum Access;
  type.field<&IntegerSequencer::keyValue>("keyValue", inputOutput, {})
      .means("the values at the keys, in order");
  type.field<&IntegerSequencer::value_changed>("value_changed", outputOnly, 0)
      .means("the value at the fraction");
}

}  // namespace pleura
