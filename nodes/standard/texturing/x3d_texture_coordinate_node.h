#pragma once

#include <pleura/nodes/standard/rendering/x3d_geometric_property_node.h>

namespace pleura {

/// Where in a texture the points of a geometry lie.
class X3DTextureCoordinateNode : public X3DGeometricPropertyNode {};

}  // namespace pleura
