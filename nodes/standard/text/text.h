#pragma once

#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/standard/rendering/x3d_geometry_node.h>
#include <pleura/nodes/standard/text/x3d_font_style_node.h>

namespace pleura {

/// Lines of text in the plane z = 0.
class Text : public X3DGeometryNode {
 public:
  TypedSFNode<X3DFontStyleNode> fontStyle;
  MFFloat length;
  SFFloat maxExtent;
  SFBool solid;
  MFString string;
  MFVec2f lineBounds;
  SFVec3f origin;
  SFVec2f textBounds;

  static void declare(NodeType& type);
};

}  // namespace pleura
