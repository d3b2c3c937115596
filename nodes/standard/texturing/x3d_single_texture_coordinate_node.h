#pragma once

#include <pleura/nodes/standard/texturing/x3d_texture_coordinate_node.h>

namespace pleura {

/// Coordinates for one texture.
class X3DSingleTextureCoordinateNode : public X3DTextureCoordinateNode {
 public:
  SFString mapping;

  static void declare(NodeType& type);
};

}  // namespace pleura
