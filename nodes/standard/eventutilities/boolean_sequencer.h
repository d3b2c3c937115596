#pragma once

#include <pleura/nodes/standard/eventutilities/x3d_sequencer_node.h>

namespace pleura {

/// Booleans step by step.
class BooleanSequencer : public X3DSequencerNode {
 public:
  MFBool keyValue;
  SFBool value_changed;

  static void declare(NodeType& type);
};

}  // namespace pleura
