#pragma once

#include <pleura/nodes/standard/core/field_watch.h>
#include <pleura/nodes/standard/rendering/x3d_color_node.h>

namespace pleura {

/// Colours of a geometry.
class Color : public X3DColorNode {
 public:
  MFColor color;

  static void declare(NodeType& type);

  std::span<const RGBA> colors() override;
  Field& source() override { return color; }

 private:
  FieldWatch watch_;
  std::vector<RGBA> colors_;
};

}  // namespace pleura
