#pragma once

#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// FIXME.
class X3DSequencerNode : public X3DChildNode {
 public:
  MFFloat key;
  SFBool next;
  SFBool previous;
  SFFloat set_fraction;

  static void declare(NodeType& type);
};

}  // namespace pleura
