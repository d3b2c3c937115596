#pragma once

#include <pleura/nodes/core/node.h>

namespace pleura {

/// A node that may stand among the children of a grouping node.
class X3DChildNode : public Node {};

}  // namespace pleura
