#pragma once

#include <span>
#include <string_view>

#include <pleura/haptics/device/device_capabilities.h>

namespace pleura::haptics {

/// Devices as they are sold.
std::span<const DeviceCapabilities> devicePresets();

/// That of the model, letters' case ignored. Throws DeviceError with the nearest known name.
const DeviceCapabilities& devicePreset(std::string_view model);

}  // namespace pleura::haptics
