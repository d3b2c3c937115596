#pragma once

#include <pleura/nodes/chain/touch.h>

namespace pleura::chain {

/// A node whose points others follow.
class Leader {
 public:
  /// The contacts whose points of this node's `field` holds, source after source in the order of
  /// their routes; null when it is no such field.
  virtual TouchInput* contactsOf(const Field& field) = 0;

 protected:
  ~Leader() = default;
};

}  // namespace pleura::chain
