#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/texturing/texture_coordinate.h>

namespace pleura {

void TextureCoordinate::declare(NodeType& type) {
  X3DSingleTextureCoordinateNode::declare(type);
  type.named("TextureCoordinate", "Texturing", 1).containedIn("texCoord").means("points of a texture");
  using enum Access;
  type.field<&TextureCoordinate::point>("point", inputOutput, {}).means("points of the texture");
}

}  // namespace pleura
