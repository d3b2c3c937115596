#pragma once

#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// A node that informs and shows nothing.
class X3DInfoNode : public X3DChildNode {};

}  // namespace pleura
