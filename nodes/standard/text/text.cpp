#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/text/text.h>

namespace pleura {

void Text::declare(NodeType& type) {
  X3DGeometryNode::declare(type);
  type.named("Text", "Text", 1).containedIn("geometry").means("lines of text in the plane z = 0");
  using enum Access;
  type.field<&Text::fontStyle>("fontStyle", inputOutput, {}).means("how the text is set");
  type.field<&Text::length>("length", inputOutput, {})
      .measuredIn(Unit::length)
      .atLeast(0)
      .means("length of each line; 0: as it comes");
  type.field<&Text::maxExtent>("maxExtent", inputOutput, 0)
      .measuredIn(Unit::length)
      .atLeast(0)
      .means("most that a line may take; 0: any");
  type.field<&Text::solid>("solid", initializeOnly, false).means("whether only front faces are drawn");
  type.field<&Text::string>("string", inputOutput, {}).means("the lines");
  type.field<&Text::lineBounds>("lineBounds", outputOnly, {})
      .measuredIn(Unit::length)
      .means("width and height of each line");
  type.field<&Text::origin>("origin", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("where the text begins");
  type.field<&Text::textBounds>("textBounds", outputOnly, Vec2f::Zero())
      .measuredIn(Unit::length)
      .means("width and height of the text");
}

}  // namespace pleura
