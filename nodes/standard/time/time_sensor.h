#pragma once

#include <pleura/nodes/core/event_handler.h>
#include <pleura/nodes/standard/time/x3d_time_dependent_node.h>

namespace pleura {

/// A clock that sends events as time passes (X3D 8.2.4, 8.4.1). What happens between two ticks counts from
/// the moment it is due, not from the tick: a cycle ends with fraction 1 and a pause holds what it was at
/// pauseTime. Never runs while cycleInterval is 0, nor from a startTime of 0 or before, the year 1970, unless
/// it loops or the time is set after loading.
class TimeSensor : public X3DTimeDependentNode {
 public:
  SFTime cycleInterval;
  SFBool enabled;
  SFBool loop;
  SFTime cycleTime;
  SFFloat fraction_changed;
  SFTime time;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  void hear();
  void refuseChanges();
  bool mayStart(Time now);
  void start();
  void run(Time now);
  void pause(Time at);
  void resume(Time at);
  void advance(Time now);
  void finish();

  // As they were when it became active; events that would change them are ignored until it stops.
  Time start_ = 0;
  Time stop_ = 0;
  Time interval_ = 1;
  Time began_ = 0;     // when it became active
  Time paused_ = 0;    // how long it has paused since then
  Time pausedAt_ = 0;  // when it paused last
  double cycle_ = 0;   // number of the cycle that runs
  Time sentAt_ = 0;    // the time of the last outputs
  Time heardAt_ = 0;   // up to which everything has been dealt with
  bool isPast_ = false;
  EventHandler onEvent_{[this] { hear(); }};
};

}  // namespace pleura
