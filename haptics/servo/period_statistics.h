#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace pleura::haptics {

/// How well a loop keeps its period: a histogram of microseconds, so that a hundred million ticks take no
/// more memory than one. Written by one thread, read by any, none waiting.
class PeriodStatistics {
 public:
  /// A tick came this long [s] after the one before. `isMissed`: so late that the next one's deadline had
  /// passed.
  void add(double period, bool isMissed);

  std::int64_t count() const { return count_.load(std::memory_order_relaxed); }
  std::int64_t missed() const { return missed_.load(std::memory_order_relaxed); }
  double longest() const { return longest_.load(std::memory_order_relaxed); }
  /// The period [s] that a part q of all, 0 < q <= 1, did not exceed, to a microsecond; 0 of none.
  double quantile(double q) const;

 private:
  static constexpr int kBins = 4096;  // the last one holds all that is longer

  std::array<std::atomic<std::int64_t>, kBins> bins_{};
  std::atomic<std::int64_t> count_ = 0;
  std::atomic<std::int64_t> missed_ = 0;
  std::atomic<double> longest_ = 0;
};

}  // namespace pleura::haptics
