#pragma once

#include <span>

#include <pleura/nodes/standard/grouping/transform.h>
#include <pleura/nodes/standard/grouping/x3d_bounded_object.h>

namespace pleura {

/// What of a node's inside is displayed.
inline std::span<const NodePtr> inside(Node& node) {
  auto* object = dynamic_cast<X3DBoundedObject*>(&node);
  return object != nullptr ? object->displayed() : std::span<const NodePtr>();
}

/// The frame that a node's inside stands in, of the frame that the node stands in.
inline Matrix4f placed(Node& node, const Matrix4f& toWorld) {
  auto* transform = dynamic_cast<Transform*>(&node);
  return transform != nullptr ? Matrix4f(toWorld * transform->matrix.getValue()) : toWorld;
}

}  // namespace pleura
