#pragma once

#include <pleura/fields/field_types.h>
#include <pleura/nodes/core/node.h>

namespace pleura {

/// An SFNode for nodes of class T.
template <class T>
class TypedSFNode : public SFNode {
 public:
  bool admits(const Node& node) const override { return dynamic_cast<const T*>(&node) != nullptr; }
  /// The node, evaluated first; null when there is none or it is of another class.
  T* get() { return dynamic_cast<T*>(getValue(getOwner()).get()); }
};

/// An MFNode for nodes of class T.
template <class T>
class TypedMFNode : public MFNode {
 public:
  bool admits(const Node& node) const override { return dynamic_cast<const T*>(&node) != nullptr; }
};

}  // namespace pleura
