#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/sine_function.h>

namespace pleura {

void SineFunction::declare(NodeType& type) {
  Node::declare(type);
  type.named("SineFunction", "Pleura")
      .containedIn("xFunction")
      .means("amplitude sin(2 pi frequency t + phase)");
  using enum Access;
  type.field<&SineFunction::amplitude>("amplitude", inputOutput, 1).means("largest value");
  type.field<&SineFunction::frequency>("frequency", inputOutput, 1)
      .measuredIn(Unit::frequency)
      .within(0, 500)
      .means("periods a second; the loop gives up to half its rate");
  type.field<&SineFunction::phaseDelay>("phaseDelay", inputOutput, 0)
      .measuredIn(Unit::angle)
      .means("phase at time 0");
}

}  // namespace pleura
