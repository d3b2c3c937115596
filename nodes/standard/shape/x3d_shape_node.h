#pragma once

#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>
#include <pleura/nodes/standard/grouping/x3d_bounded_object.h>
#include <pleura/nodes/standard/rendering/x3d_geometry_node.h>
#include <pleura/nodes/standard/shape/x3d_appearance_node.h>

namespace pleura {

/// A geometry and its looks at a place of the scene.
class X3DShapeNode : public X3DChildNode, public X3DBoundedObject {
 public:
  TypedSFNode<X3DAppearanceNode> appearance;
  SFBool castShadow;
  TypedSFNode<X3DGeometryNode> geometry;

  /// Starts what takes long of the shape, if it is out of date, beside what else is to be done: called for
  /// all that somebody is about to read, before the first is read.
  virtual void begin() {}

  static void declare(NodeType& type);
};

}  // namespace pleura
