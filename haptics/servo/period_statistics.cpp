#include <algorithm>
#include <cmath>

#include <pleura/haptics/servo/period_statistics.h>

namespace pleura::haptics {

namespace {

constexpr double kBin = 1e-6;  // [s]

/// There is one writer: no update gets lost between load and store.
template <class T>
void increase(std::atomic<T>& number, T by) {
  number.store(number.load(std::memory_order_relaxed) + by, std::memory_order_relaxed);
}

}  // namespace

void PeriodStatistics::add(double period, bool isMissed) {
  const double bin = std::clamp(std::round(period / kBin), 0.0, static_cast<double>(kBins - 1));
  increase<std::int64_t>(bins_[static_cast<std::size_t>(bin)], 1);
  increase<std::int64_t>(count_, 1);
  increase<std::int64_t>(missed_, isMissed ? 1 : 0);
  longest_.store(std::max(longest(), period), std::memory_order_relaxed);
}

double PeriodStatistics::quantile(double q) const {
  const auto wanted = static_cast<std::int64_t>(std::ceil(q * static_cast<double>(count())));
  std::int64_t seen = 0;
  for (int bin = 0; bin < kBins - 1; ++bin) {
    seen += bins_[static_cast<std::size_t>(bin)].load(std::memory_order_relaxed);
    if (seen >= wanted && seen > 0) return bin * kBin;
  }
  return longest();
}

}  // namespace pleura::haptics
