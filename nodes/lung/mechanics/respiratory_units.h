#pragma once

namespace pleura {

/// What pressures and volumes of breathing are told in, in SI.
inline constexpr double kCmH2O = 98.0665;  // [Pa] a centimetre of water
inline constexpr double kLitre = 1e-3;     // [m^3]

}  // namespace pleura
