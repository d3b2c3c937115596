#pragma once

#include <pleura/nodes/core/node.h>

namespace pleura {

/// A number that changes as the sine of time.
class SineFunction : public Node {
 public:
  SFFloat amplitude;
  SFFloat frequency;
  SFFloat phaseDelay;

  static void declare(NodeType& type);
};

}  // namespace pleura
