#include <algorithm>
#include <cmath>
#include <limits>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/core/scene_context.h>
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

void TimeSensor::onInitialize() {
  heardAt_ = context().time.getValue();
  isPast_ = startTime.getValue() <= 0;
  onEvent_.hears(*this, startTime, stopTime, pauseTime, resumeTime, cycleInterval, loop, enabled,
                 context().time);
}

void TimeSensor::hear() {
  const Time now = context().time.getValue();
  if (onEvent_.heard(startTime)) isPast_ = false;
  if (isActive.getValue()) {
    refuseChanges();
  } else if (mayStart(now)) {
    start();
  }
  if (isActive.getValue()) run(now);
  heardAt_ = now;
}

void TimeSensor::refuseChanges() {
  startTime.setValueIfChanged(start_);
  cycleInterval.setValueIfChanged(interval_);
  if (stopTime.getValue() > start_) stop_ = stopTime.getValue();
  stopTime.setValueIfChanged(stop_);
}

bool TimeSensor::mayStart(Time now) {
  const Time from = startTime.getValue();
  const Time until = stopTime.getValue();
  const Time interval = cycleInterval.getValue();
  const Time begin = std::max(from, heardAt_);
  if (!enabled.getValue() || !(interval > 0) || now < from) return false;
  if (until > from && begin >= until) return false;
  return loop.getValue() || (!isPast_ && begin < from + interval);
}

void TimeSensor::start() {
  start_ = startTime.getValue();
  stop_ = stopTime.getValue();
  interval_ = cycleInterval.getValue();
  began_ = heardAt_ = std::max(start_, heardAt_);
  paused_ = 0;
  cycle_ = -1;
  sentAt_ = -std::numeric_limits<Time>::infinity();
  isActive.setValue(true, id);
  advance(began_);
}

void TimeSensor::run(Time now) {
  constexpr Time kNever = std::numeric_limits<Time>::infinity();
  const Time stop = stop_ > start_ ? std::max(stop_, heardAt_) : kNever;
  if (isPaused.getValue()) {
    if (resumeTime.getValue() > pauseTime.getValue() && resumeTime.getValue() <= now) {
      resume(std::max(resumeTime.getValue(), heardAt_));
    } else {
      if (stop <= now || !enabled.getValue()) finish();
      return;
    }
  }
  const Time end = loop.getValue() ? stop : std::min(stop, start_ + paused_ + (cycle_ + 1) * interval_);
  if (pauseTime.getValue() > resumeTime.getValue() && pauseTime.getValue() <= now) {
    const Time at = std::max(pauseTime.getValue(), heardAt_);
    if (at < end && enabled.getValue()) return pause(at);
  }
  advance(std::min(now, end));
  if (end <= now || !enabled.getValue()) finish();
}

void TimeSensor::pause(Time at) {
  advance(at);
  pausedAt_ = at;
  isPaused.setValue(true, id);
  pauseTime.setValueIfChanged(at);
}

void TimeSensor::resume(Time at) {
  paused_ += at - pausedAt_;
  isPaused.setValue(false, id);
  resumeTime.setValueIfChanged(at);
}

// f = frac((now - startTime) / cycleInterval), but 1 where that is 0 and now > startTime (8.4.1)
void TimeSensor::advance(Time now) {
  if (now <= sentAt_) return;
  sentAt_ = now;
  double cycles = (now - start_ - paused_) / interval_;
  // Ticks are sums of steps: what is a whole number of cycles but for rounding is one.
  const double rounding = 1e-12 + 1e-15 * std::abs(now) / interval_;
  if (std::abs(cycles - std::round(cycles)) < rounding) cycles = std::round(cycles);
  const bool isCycleEnd = cycles == std::floor(cycles) && cycles > 0;
  const double cycle = isCycleEnd ? cycles - 1 : std::floor(cycles);
  if (cycle != cycle_) cycleTime.setValue(start_ + paused_ + cycle * interval_, id);
  cycle_ = cycle;
  elapsedTime.setValue(now - began_ - paused_, id);
  fraction_changed.setValue(static_cast<float>(cycles - cycle), id);
  time.setValue(now, id);
}

void TimeSensor::finish() {
  if (isPaused.getValue()) isPaused.setValue(false, id);
  isActive.setValue(false, id);
}

}  // namespace pleura
