#pragma once

#include <algorithm>
#include <cmath>

#include <pleura/haptics/device/haptic_device.h>

namespace pleura::haptics {

/// Whether all components are numbers; raises no floating-point exception.
template <class Vector>
bool isFinite(const Eigen::MatrixBase<Vector>& v) {
  return std::all_of(v.derived().begin(), v.derived().end(), [](double x) { return std::isfinite(x); });
}

inline bool isFinite(const DeviceState& state) {
  return isFinite(state.position) && isFinite(state.velocity) && isFinite(state.orientation.coeffs());
}

}  // namespace pleura::haptics
