#pragma once

#include <pleura/nodes/standard/text/x3d_font_style_node.h>

namespace pleura {

/// Font, size and alignment of text.
class FontStyle : public X3DFontStyleNode {
 public:
  MFString family;
  SFBool horizontal;
  MFString justify;
  SFString language;
  SFBool leftToRight;
  SFFloat size;
  SFFloat spacing;
  SFString style;
  SFBool topToBottom;

  static void declare(NodeType& type);
};

}  // namespace pleura
