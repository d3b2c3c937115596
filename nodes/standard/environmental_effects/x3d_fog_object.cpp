#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/environmental_effects/x3d_fog_object.h>

namespace pleura {

void X3DFogObject::declare(NodeType& type) {
  using enum Access;
  type.field<&X3DFogObject::color>("color", inputOutput, RGB(1, 1, 1))
      .within(0, 1)
      .means("colour of what is lost in fog");
  type.field<&X3DFogObject::fogType>("fogType", inputOutput, "LINEAR").means("LINEAR or EXPONENTIAL loss");
  type.field<&X3DFogObject::visibilityRange>("visibilityRange", inputOutput, 0)
      .measuredIn(Unit::length)
      .atLeast(0)
      .means("distance at which nothing is seen any more; 0: no fog");
}

}  // namespace pleura
