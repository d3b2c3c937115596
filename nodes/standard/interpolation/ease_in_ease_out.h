#pragma once

#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// A fraction that starts and stops gently between keys.
class EaseInEaseOut : public X3DChildNode {
 public:
  MFVec2f easeInEaseOut;
  MFFloat key;
  SFFloat set_fraction;
  SFFloat modifiedFraction_changed;

  static void declare(NodeType& type);
};

}  // namespace pleura
