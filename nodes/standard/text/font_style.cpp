#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/text/font_style.h>

namespace pleura {

void FontStyle::declare(NodeType& type) {
  Node::declare(type);
  type.named("FontStyle", "Text", 1).containedIn("fontStyle").means("font, size and alignment of text");
  using enum Access;
  type.field<&FontStyle::family>("family", inputOutput, {"SERIF"})
      .means("fonts to be tried: SERIF, SANS, TYPEWRITER or a name");
  type.field<&FontStyle::horizontal>("horizontal", inputOutput, true)
      .means("whether lines run across, or down");
  type.field<&FontStyle::justify>("justify", inputOutput, {"BEGIN"})
      .means("alignment along the line, and across: BEGIN, FIRST, MIDDLE or END");
  type.field<&FontStyle::language>("language", inputOutput, {})
      .means("language of the text, as RFC 3066 names it");
  type.field<&FontStyle::leftToRight>("leftToRight", inputOutput, true)
      .means("whether letters follow one another to the right");
  type.field<&FontStyle::size>("size", inputOutput, 1)
      .measuredIn(Unit::length)
      .positive()
      .means("height of a line");
  type.field<&FontStyle::spacing>("spacing", inputOutput, 1)
      .atLeast(0)
      .means("distance of two lines, in line heights");
  type.field<&FontStyle::style>("style", inputOutput, "PLAIN").means("PLAIN, BOLD, ITALIC or BOLDITALIC");
  type.field<&FontStyle::topToBottom>("topToBottom", inputOutput, true)
      .means("whether lines follow one another downwards");
}

}  // namespace pleura
