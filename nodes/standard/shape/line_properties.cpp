#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/shape/line_properties.h>

namespace pleura {

void LineProperties::declare(NodeType& type) {
  Node::declare(type);
  type.named("LineProperties", "Shape", 2).containedIn("lineProperties").means("how lines are drawn");
  using enum Access;
  type.field<&LineProperties::applied>("applied", inputOutput, true).means("whether these properties count");
  type.field<&LineProperties::linetype>("linetype", inputOutput, 1)
      .atLeast(0)
      .means("number of the dash pattern: 1 solid");
  type.field<&LineProperties::linewidthScaleFactor>("linewidthScaleFactor", inputOutput, 0)
      .means("times the thinnest line; 0 or less: the thinnest");
}

}  // namespace pleura
