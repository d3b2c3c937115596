#pragma once

#include <atomic>
#include <thread>

#include <pleura/haptics/servo/period_statistics.h>
#include <pleura/haptics/servo/servo.h>

namespace pleura::haptics {

/// Ticks a servo on a thread of its own at absolute deadlines, so that nothing drifts: a tick that comes late
/// does not move those after it. Nothing inside waits for another thread.
class ServoLoop {
 public:
  /// Starts at once, its clock at `time` [s]. `wantsRealTime`: asks the system for SCHED_FIFO, and goes on
  /// without where it is refused.
  ServoLoop(Servo& servo, double time, bool wantsRealTime);
  /// Ends the thread after the tick it is in.
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  bool isRealTime() const { return isRealTime_.load(std::memory_order_relaxed); }
  /// May be read while the loop runs.
  const PeriodStatistics& periods() const { return periods_; }
  /// [s] that the last tick took.
  double lastDuration() const { return lastDuration_.load(std::memory_order_relaxed); }

 private:
  void run(double time, bool wantsRealTime);

  Servo& servo_;
  PeriodStatistics periods_;
  std::atomic<double> lastDuration_ = 0;
  std::atomic<bool> isRealTime_ = false;
  std::atomic<bool> shallStop_ = false;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace pleura::haptics
