#pragma once

#include <pleura/nodes/standard/shape/x3d_appearance_child_node.h>

namespace pleura {

/// How light and a surface meet.
class X3DMaterialNode : public X3DAppearanceChildNode {};

}  // namespace pleura
