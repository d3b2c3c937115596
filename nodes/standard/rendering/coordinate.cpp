#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/coordinate.h>

namespace pleura {

void Coordinate::declare(NodeType& type) {
  Node::declare(type);
  type.named("Coordinate", "Rendering", 1).containedIn("coord").means("points of a geometry");
  using enum Access;
  type.field<&Coordinate::point>("point", inputOutput, {}).measuredIn(Unit::length).means("points");
}

}  // namespace pleura
