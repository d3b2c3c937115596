#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

namespace pleura {

/// Throws std::invalid_argument, which says what it is about, unless `value` is finite and positive.
inline void requirePositive(double value, const std::string& what) {
  if (!(std::isfinite(value) && value > 0)) throw std::invalid_argument(what + " must be a positive number");
}

}  // namespace pleura
