#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/time/time_sensor.h>

namespace pleura {

void TimeSensor::declare(NodeType& type) {
  X3DTimeDependentNode::declare(type);
  type.named("TimeSensor", "Time", 1).means("a clock that sends events as time passes");
  using enum Access;
  type.field<&TimeSensor::cycleInterval>("cycleInterval", inputOutput, 1)
      .measuredIn(Unit::time)
      .atLeast(0)
      .means("length of a cycle");
  type.field<&TimeSensor::enabled>("enabled", inputOutput, true).means("whether the clock may run");
  type.field<&TimeSensor::loop>("loop", inputOutput, false).means("whether a new cycle follows each");
  type.field<&TimeSensor::cycleTime>("cycleTime", outputOnly, 0)
      .measuredIn(Unit::time)
      .means("when the cycle began");
  type.field<&TimeSensor::fraction_changed>("fraction_changed", outputOnly, 0)
      .means("share of the cycle that has passed, 0 to 1");
  type.field<&TimeSensor::time>("time", outputOnly, 0).measuredIn(Unit::time).means("the time now");
}

}  // namespace pleura
