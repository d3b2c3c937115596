#pragma once

#include <pleura/nodes/core/node_type.h>

namespace pleura {

/// Light that gets lost on its way.
class X3DFogObject {
 public:
  SFColor color;
  SFString fogType;
  SFFloat visibilityRange;

  static void declare(NodeType& type);
};

}  // namespace pleura
