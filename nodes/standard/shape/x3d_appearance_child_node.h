#pragma once

#include <pleura/nodes/core/node.h>

namespace pleura {

/// A part of an Appearance.
class X3DAppearanceChildNode : public Node {};

}  // namespace pleura
