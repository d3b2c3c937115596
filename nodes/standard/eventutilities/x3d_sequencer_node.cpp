#include <algorithm>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/eventutilities/x3d_sequencer_node.h>
#include <pleura/nodes/standard/interpolation/key_interval.h>

namespace pleura {

void X3DSequencerNode::declare(NodeType& type) {
  Node::declare(type);
  using enum Access;
  type.field<&X3DSequencerNode::key>("key", inputOutput, {})
      .means("fractions, rising, at which the values change");
  type.field<&X3DSequencerNode::next>("next", inputOnly, false).means("true goes one step on");
  type.field<&X3DSequencerNode::previous>("previous", inputOnly, false).means("true goes one step back");
  type.field<&X3DSequencerNode::set_fraction>("set_fraction", inputOnly, 0).means("where between the keys");
}

void X3DSequencerNode::onInitialize() { onEvent_.hears(*this, set_fraction, next, previous); }

void X3DSequencerNode::hear() {
  const std::size_t count = std::min(key.size(), valueCount());
  if (count == 0) return;
  const std::size_t before = current_.value_or(0) % count;
  std::optional<std::size_t> number;
  if (onEvent_.heard(set_fraction)) {
    const std::span<const float> keys = key.getValue();
    number = findKeyInterval(keys.first(count), set_fraction.getValue(id)).from;
    if (number == current_) number.reset();
  }
  if (onEvent_.heard(next) && next.getValue(id)) number = (before + 1) % count;
  if (onEvent_.heard(previous) && previous.getValue(id)) number = (before + count - 1) % count;
  if (!number) return;
  current_ = number;
  send(*number);
}

}  // namespace pleura
