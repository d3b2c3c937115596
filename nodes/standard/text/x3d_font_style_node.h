#pragma once

#include <pleura/nodes/core/node.h>

namespace pleura {

/// How text is set.
class X3DFontStyleNode : public Node {};

}  // namespace pleura
