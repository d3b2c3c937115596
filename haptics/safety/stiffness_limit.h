#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <pleura/haptics/device/device_capabilities.h>

namespace pleura::haptics {

/// The stiffness [N/m] up to which a wall, rendered from samples and held over each period T [s], gives back
/// no more energy than the device's damping b [N s/m] takes, when damping B [N s/m] is rendered with it:
///   b > K T / 2 + |B|,   K_max = 2 (b - |B|) / T
/// At least 0. Source: Colgate and Schenkel, J. Robotic Systems 14(1), 1997. A delay t_d between sample and
/// force adds to T / 2.
inline double stiffnessLimit(double b, double B, double T) {
  return std::max(0.0, 2 * (b - std::abs(B)) / T);
}

/// The damping [N s/m] that may be rendered with stiffness K: |B|_max = b - K T / 2, at least 0. Same source.
inline double dampingLimit(double b, double K, double T) { return std::max(0.0, b - K * T / 2); }

/// The stiffness [N/m] up to which Coulomb friction f_c [N] takes what steps Delta [m] of an encoder give:
///   K_max = 2 f_c / Delta
/// Without steps there is no limit. Source: Abbott and Okamura, IEEE Trans. Robotics 21(5), 2005.
inline double quantizationStiffnessLimit(double friction, double encoderStep) {
  return encoderStep > 0 ? 2 * friction / encoderStep : std::numeric_limits<double>::infinity();
}

/// What may be rendered on a device: the least of those limits and of the device's own. Quantisation counts
/// where the device's friction is known.
inline double stiffnessLimit(const DeviceCapabilities& device, double B, double T) {
  const double sampled = std::min(device.maxStiffness, stiffnessLimit(device.damping, B, T));
  return device.friction > 0
             ? std::min(sampled, quantizationStiffnessLimit(device.friction, device.encoderStep))
             : sampled;
}

}  // namespace pleura::haptics
