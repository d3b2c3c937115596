#pragma once

#include <pleura/nodes/standard/navigation/billboard.h>

namespace pleura {

/// The turn that faces a Billboard to the viewer (X3D 23.4.1). `toWorld` is of the group it stands in, `view`
/// from world to view.
Matrix4f billboardTurn(Billboard& node, const Matrix4f& toWorld, const Matrix4f& view);

}  // namespace pleura
