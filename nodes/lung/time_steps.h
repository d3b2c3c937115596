#pragma once

#include <algorithm>
#include <cmath>

namespace pleura {

/// Steps of equal length that a time is gone through by.
struct TimeSteps {
  int count = 1;
  double length = 0;  // [s]
};

/// For a system that is asked late: steps of 20 ms at most, unless that were more than a hundred.
inline TimeSteps timeSteps(double duration) {
  constexpr double kLongest = 0.02;  // [s]
  constexpr int kMost = 100;
  const int count = static_cast<int>(std::clamp(std::ceil(duration / kLongest), 1.0, double{kMost}));
  return {count, duration / count};
}

}  // namespace pleura
