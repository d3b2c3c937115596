#pragma once

#include <span>

#include <pleura/nodes/core/node_type.h>

namespace pleura {

/// What has contents that can be bounded by a box, and hidden.
class X3DBoundedObject {
 public:
  SFVec3f bboxCenter;
  SFBool bboxDisplay;
  SFVec3f bboxSize;
  SFBool visible;

  /// The nodes inside that are to be drawn now; none when the object is not visible.
  std::span<const NodePtr> displayed() { return visible.getValue() ? shown() : std::span<const NodePtr>(); }

  static void declare(NodeType& type);

 protected:
  ~X3DBoundedObject() = default;
  virtual std::span<const NodePtr> shown() { return {}; }
};

}  // namespace pleura
