#pragma once

#include <pleura/nodes/standard/texturing/x3d_single_texture_coordinate_node.h>

namespace pleura {

/// Points of a texture.
class TextureCoordinate : public X3DSingleTextureCoordinateNode {
 public:
  MFVec2f point;

  static void declare(NodeType& type);
};

}  // namespace pleura
