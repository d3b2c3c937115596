#pragma once

#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// A node that turns an event of one type into one of another.
class X3DTriggerNode : public X3DChildNode {};

}  // namespace pleura
