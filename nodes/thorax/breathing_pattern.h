#pragma once

#include <optional>
#include <string_view>

namespace pleura {

/// How the chest moves between its ends within one breath.
enum class BreathingPattern {
  sinusoid,  // in and out alike
  oneToTwo,  // expiration takes twice as long as inspiration, as at rest
};

/// "SINUSOID" or "ONE_TO_TWO"; nothing for any other word.
std::optional<BreathingPattern> breathingPattern(std::string_view word);

/// How far the breath is at `phase` in [0, 1]: 0 at its start and end (FRC), 1 at the top; smooth.
double excursion(BreathingPattern pattern, double phase);

}  // namespace pleura
