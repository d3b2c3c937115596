#pragma once

#include <pleura/nodes/standard/rendering/x3d_color_node.h>

namespace pleura {

/// Colours of a geometry, and how opaque it is.
class ColorRGBA : public X3DColorNode {
 public:
  MFColorRGBA color;

  static void declare(NodeType& type);

  std::span<const RGBA> colors() override { return color.getValue(); }
  Field& source() override { return color; }
};

}  // namespace pleura
