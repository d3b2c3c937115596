#pragma once

#include <pleura/nodes/core/node_type.h>

namespace pleura {

/// What is loaded from elsewhere: the first of `url` that can be.
class X3DUrlObject {
 public:
  SFTime autoRefresh;
  SFTime autoRefreshTimeLimit;
  SFString description;
  SFBool load;
  MFString url;

  static void declare(NodeType& type);
};

}  // namespace pleura
