#pragma once

#include <limits>

namespace pleura {

// What input may hold and no solver may take.
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace pleura
