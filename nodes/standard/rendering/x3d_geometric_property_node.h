#pragma once

#include <pleura/nodes/core/node.h>

namespace pleura {

/// Data of the points of a geometry.
class X3DGeometricPropertyNode : public Node {};

}  // namespace pleura
