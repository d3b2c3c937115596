#pragma once

#include <pleura/nodes/core/node.h>

namespace pleura {

/// How the geometry of a Shape looks.
class X3DAppearanceNode : public Node {};

}  // namespace pleura
