#pragma once

#include <pleura/nodes/standard/core/x3d_bindable_node.h>

namespace pleura {

/// How the viewer moves.
class NavigationInfo : public X3DBindableNode {
 public:
  MFFloat avatarSize;
  SFBool headlight;
  SFFloat speed;
  SFTime transitionTime;
  MFString transitionType;
  MFString navigationType;
  SFFloat visibilityLimit;
  SFBool transitionComplete;

  static void declare(NodeType& type);

 protected:
  std::string_view kind() const override { return "NavigationInfo"; }
};

}  // namespace pleura
