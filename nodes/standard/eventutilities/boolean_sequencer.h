#pragma once

#include <pleura/nodes/standard/eventutilities/x3d_sequencer_node.h>

namespace pleura {

/// Booleans step by step.
class BooleanSequencer : public X3DSequencerNode {
 public:
  MFBool keyValue;
  SFBool value_changed;

  static void declare(NodeType& type);

 protected:
  std::size_t valueCount() override { return keyValue.size(); }
  void send(std::size_t number) override { value_changed.setValue(keyValue.getValueByIndex(number), id); }
};

}  // namespace pleura
