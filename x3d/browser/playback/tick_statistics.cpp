#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include <pleura/nodes/deformable/solve_counter.h>
#include <pleura/x3d/browser/playback/tick_statistics.h>

namespace pleura {

void TickStatistics::begin() {
  fieldsBefore_ = fieldCounters();
  solvesBefore_ = solveCounter();
  start_ = std::chrono::steady_clock::now();
}

void TickStatistics::end() {
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start_;
  milliseconds_.push_back(spent.count());
  spent_.updates += fieldCounters().updates - fieldsBefore_.updates;
  spent_.events += fieldCounters().events - fieldsBefore_.events;
  solves_ += solveCounter() - solvesBefore_;
}

double TickStatistics::quantile(double q) const {
  if (milliseconds_.empty()) return 0;
  auto sorted = milliseconds_;
  const auto nth =
      sorted.begin() + static_cast<std::ptrdiff_t>(std::lround(q * static_cast<double>(sorted.size() - 1)));
  std::nth_element(sorted.begin(), nth, sorted.end());
  return *nth;
}

std::string TickStatistics::toJson(const TouchSession::Statistics& touch) const {
  const double count = std::max<double>(1, static_cast<double>(ticks()));
  nlohmann::ordered_json json{
      {"ticks", ticks()},
      {"msPerTick", {{"median", quantile(0.5)}, {"p99", quantile(0.99)}, {"max", quantile(1)}}},
      {"updatesPerTick", static_cast<double>(spent_.updates) / count},
      {"eventsPerTick", static_cast<double>(spent_.events) / count},
      {"solvesPerTick", static_cast<double>(solves_) / count}};
  constexpr double kMicroseconds = 1e6;
  if (touch.ticks > 0)
    json["haptics"] = {{"ticks", touch.ticks},
                       {"missed", touch.missed},
                       {"usPeriod",
                        {{"p50", touch.p50 * kMicroseconds},
                         {"p99", touch.p99 * kMicroseconds},
                         {"p99.9", touch.p999 * kMicroseconds},
                         {"max", touch.longest * kMicroseconds}}},
                       {"treesBuilt", touch.treesBuilt},
                       {"treesRefitted", touch.treesRefitted}};
  return json.dump(2);
}

}  // namespace pleura
