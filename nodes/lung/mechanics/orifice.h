#pragma once

#include <cmath>

namespace pleura {

/// Gas through a hole with sharp edges.
struct Orifice {
  double area = 0;                    // A [m^2] >= 0
  double dischargeCoefficient = 0.6;  // C_d, that of a sharp-edged hole
};

/// The flow [m^3/s] from high to low, and how it changes with the pressure difference.
struct OrificeFlow {
  double q = 0;
  double slope = 0;  // dq/d(dp) [m^3/(s Pa)]
};

/// Below this pressure difference [Pa] a hole's flow is linear rather than a square root's: so is the flow of
/// any real one when it is slow enough, and the slope stays finite.
inline constexpr double kLaminarPressure = 0.1;

/// Either way through a hole, dp [Pa] the pressure above that of the other side, rho [kg/m^3] > 0:
///   q = C_d A sqrt(2 / rho) dp / (dp^2 + e^2)^(1/4),  e = kLaminarPressure,
/// which is C_d A sqrt(2 dp / rho) within 0.3 % from a pascal on.
inline OrificeFlow orificeFlow(const Orifice& hole, double dp, double rho) {
  const double e2 = kLaminarPressure * kLaminarPressure, r2 = dp * dp + e2, r = std::sqrt(r2);
  const double k = hole.dischargeCoefficient * hole.area * std::sqrt(2 / (rho * r));
  return {k * dp, k * (0.5 * dp * dp + e2) / r2};
}

}  // namespace pleura
