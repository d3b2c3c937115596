#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <pleura/fields/counters.h>
#include <pleura/x3d/browser/touch/touch_session.h>

namespace pleura {

/// What ticks cost: milliseconds, and how many fields were updated and organs solved.
class TickStatistics {
 public:
  void begin();
  void end();

  std::size_t ticks() const { return milliseconds_.size(); }
  /// Of the ticks' milliseconds, q in [0, 1]; 0 before the first.
  double quantile(double q) const;
  /// JSON: ticks, msPerTick {median, p99, max}, updatesPerTick, eventsPerTick, solvesPerTick; and of haptic
  /// loops, where there are: haptics {ticks, missed, usPeriod {p50, p99, p99.9, max}, treesBuilt,
  /// treesRefitted}.
  std::string toJson(const TouchSession::Statistics& touch = {}) const;

 private:
  std::vector<double> milliseconds_;
  FieldCounters spent_;
  std::uint64_t solves_ = 0;
  FieldCounters fieldsBefore_;
  std::uint64_t solvesBefore_ = 0;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace pleura
