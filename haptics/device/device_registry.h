#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <pleura/haptics/device/haptic_device.h>
#include <pleura/haptics/simulated/stylus_path.h>

namespace pleura::haptics {

/// What a person says about the device that is wanted. A driver takes from it what concerns it.
struct DeviceSettings {
  // Simulated: a preset's name. Phantom: the vendor's name of the configured device. Empty: the default one.
  std::string model = {};
  // Simulated: the hand's path. Recorded: the recording.
  std::filesystem::path file = {};
  // Simulated: in place of the preset's.
  std::optional<DeviceCapabilities> capabilities = {};
  // Simulated: the hand's path where there is no file; none: it rests at the origin.
  std::vector<StylusWaypoint> waypoints = {};
  // Simulated: how the hand holds the tip.
  double handStiffness = 200;  // [N/m]
  double handDamping = 2;      // [N s/m]
};

/// Drivers of devices by name.
class DeviceRegistry {
 public:
  using Factory = std::function<std::unique_ptr<HapticDevice>(const DeviceSettings&)>;

  /// A second driver of a name takes the place of the first.
  void add(std::string driver, Factory factory);

  /// A device that is not open yet. Throws DeviceError: an unknown driver, with the nearest known name, or
  /// settings that the driver refuses.
  std::unique_ptr<HapticDevice> make(std::string_view driver, const DeviceSettings& settings) const;

  /// Throws DeviceError for an unknown driver, with the nearest known name.
  void check(std::string_view driver) const;

  std::vector<std::string_view> names() const;

 private:
  const Factory* find(std::string_view driver) const;

  std::map<std::string, Factory, std::less<>> drivers_;
};

}  // namespace pleura::haptics
