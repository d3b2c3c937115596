#pragma once

#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/standard/core/x3d_bindable_node.h>
#include <pleura/nodes/standard/navigation/navigation_info.h>

namespace pleura {

/// A place to look from.
class X3DViewpointNode : public X3DBindableNode {
 public:
  SFString description;
  SFFloat farDistance;
  SFBool jump;
  TypedSFNode<NavigationInfo> navigationInfo;
  SFFloat nearDistance;
  SFRotation orientation;
  SFBool retainUserOffsets;
  SFBool viewAll;

  static void declare(NodeType& type);

 protected:
  std::string_view kind() const override { return "Viewpoint"; }
};

}  // namespace pleura
