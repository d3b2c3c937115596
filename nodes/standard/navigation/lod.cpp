#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/navigation/lod.h>

namespace pleura {

void LOD::declare(NodeType& type) {
  X3DGroupingNode::declare(type);
  type.named("LOD", "Navigation", 2).means("one child, by its distance from the viewer");
  using enum Access;
  type.field<&LOD::center>("center", initializeOnly, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("point from which the viewer's distance is taken");
  type.field<&LOD::forceTransitions>("forceTransitions", initializeOnly, false)
      .means("whether every change of level is made, however busy");
  type.field<&LOD::range>("range", initializeOnly, {})
      .measuredIn(Unit::length)
      .means("distances at which the levels change");
  type.field<&LOD::level_changed>("level_changed", outputOnly, 0)
      .atLeast(0)
      .means("number of the child that is shown");
}

}  // namespace pleura
