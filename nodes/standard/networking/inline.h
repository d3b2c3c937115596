#pragma once

#include <pleura/nodes/standard/core/x3d_child_node.h>
#include <pleura/nodes/standard/grouping/x3d_bounded_object.h>
#include <pleura/nodes/standard/networking/x3d_url_object.h>

namespace pleura {

/// The scene of another file.
class Inline : public X3DChildNode, public X3DBoundedObject, public X3DUrlObject {
 public:
  SFBool global;

  MFNode contents;  // what was loaded; no field of X3D's

  static void declare(NodeType& type);

 protected:
  std::span<const NodePtr> shown() override { return contents.getValue(); }
};

}  // namespace pleura
