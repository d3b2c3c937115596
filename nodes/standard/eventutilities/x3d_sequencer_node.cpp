#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/eventutilities/x3d_sequencer_node.h>

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

}  // namespace pleura
