#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include <pleura/haptics/device/device_capabilities.h>
#include <pleura/haptics/device/haptic_device.h>

namespace pleura::haptics {

namespace {

// No sum or square of figures of this size is more than a double can hold.
constexpr double kLargest = 1e9;

}  // namespace

void DeviceCapabilities::check() const {
  const auto number = [this](std::string_view figure, double value, bool mayBeZero) {
    if (std::isfinite(value) && value <= kLargest && (mayBeZero ? value >= 0 : value > 0)) return;
    throw DeviceError(fmt::format("device \"{}\": {} is {}, expected {} and at most {:g}", model, figure,
                                  value, mayBeZero ? "0 or more" : "more than 0", kLargest));
  };
  const auto count = [this](std::string_view figure, int value, int least, int most) {
    if (value >= least && value <= most) return;
    throw DeviceError(
        fmt::format("device \"{}\": {} is {}, expected {} to {}", model, figure, value, least, most));
  };
  number("maxForce", maxForce, false);
  number("maxTorque", maxTorque, true);
  number("maxStiffness", maxStiffness, false);
  number("maxDamping", maxDamping, true);
  number("workspaceRadius", workspaceRadius, false);
  number("mass", mass, false);
  number("damping", damping, true);
  number("friction", friction, true);
  number("encoderStep", encoderStep, true);
  count("inputDof", inputDof, 3, 7);
  count("outputDof", outputDof, 0, 7);
  count("buttons", buttons, 0, 32);
}

}  // namespace pleura::haptics
