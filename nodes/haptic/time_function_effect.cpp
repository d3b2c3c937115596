#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/time_function_effect.h>

namespace pleura {

void TimeFunctionEffect::declare(NodeType& type) {
  ForceEffectNode::declare(type);
  type.named("TimeFunctionEffect", "Pleura").means("a force on the hand that changes with time");
  using enum Access;
  type.field<&TimeFunctionEffect::xFunction>("xFunction", inputOutput, {}).means("force along x [N]");
  type.field<&TimeFunctionEffect::yFunction>("yFunction", inputOutput, {}).means("force along y [N]");
  type.field<&TimeFunctionEffect::zFunction>("zFunction", inputOutput, {}).means("force along z [N]");
}

haptics::ForceEffect::Kind TimeFunctionEffect::kindOf(const Matrix4f&) {
  haptics::PeriodicForce wave;
  int axis = 0;
  for (auto* function : {&xFunction, &yFunction, &zFunction}) {
    if (auto* sine = function->get()) {
      wave.amplitude[axis] = sine->amplitude.getValue();
      wave.frequency[axis] = sine->frequency.getValue();
      wave.phase[axis] = sine->phaseDelay.getValue();
    }
    ++axis;
  }
  return wave;
}

}  // namespace pleura
