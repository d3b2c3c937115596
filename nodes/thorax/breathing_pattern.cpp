#include <cmath>
#include <numbers>

#include <pleura/nodes/thorax/breathing_pattern.h>

namespace pleura {

std::optional<BreathingPattern> breathingPattern(std::string_view word) {
  if (word == "SINUSOID") return BreathingPattern::sinusoid;
  if (word == "ONE_TO_TWO") return BreathingPattern::oneToTwo;
  return std::nullopt;
}

double excursion(BreathingPattern pattern, double phase) {
  // x = (1 - cos(pi u)) / 2, u from 0 to 1 while breathing in and on to 2 while breathing out
  const double inspiration = pattern == BreathingPattern::oneToTwo ? 1.0 / 3 : 0.5;
  const double u = phase < inspiration ? phase / inspiration : 1 + (phase - inspiration) / (1 - inspiration);
  return (1 - std::cos(std::numbers::pi * u)) / 2;
}

}  // namespace pleura
