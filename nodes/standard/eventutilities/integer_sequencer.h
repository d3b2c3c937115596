#pragma once

#include <pleura/nodes/standard/eventutilities/x3d_sequencer_node.h>

namespace pleura {

/// Whole numbers step by step.
class IntegerSequencer : public X3DSequencerNode {
 public:
  MFInt32 keyValue;
  SFInt32 value_changed;

  static void declare(NodeType& type);

 protected:
  std::size_t valueCount() override { return keyValue.size(); }
  void send(std::size_t number) override { value_changed.setValue(keyValue.getValueByIndex(number), id); }
};

}  // namespace pleura
