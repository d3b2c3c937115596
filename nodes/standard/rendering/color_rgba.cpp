#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/color_rgba.h>

namespace pleura {

void ColorRGBA::declare(NodeType& type) {
  Node::declare(type);
  type.named("ColorRGBA", "Rendering", 1)
      .containedIn("color")
      .means("colours of a geometry, and how opaque it is");
  using enum Access;
  type.field<&ColorRGBA::color>("color", inputOutput, {}).within(0, 1).means("colours");
}

}  // namespace pleura
