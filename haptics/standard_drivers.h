#pragma once

#include <pleura/haptics/device/device_registry.h>

namespace pleura::haptics {

/// The drivers that come with Pleura.
DeviceRegistry standardDrivers();

}  // namespace pleura::haptics
