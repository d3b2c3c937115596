#include <pleura/haptics/device/device_presets.h>
#include <pleura/haptics/phantom/phantom_device.h>
#include <pleura/haptics/recorded/recorded_device.h>
#include <pleura/haptics/simulated/simulated_stylus.h>
#include <pleura/haptics/simulated/stylus_path_csv.h>
#include <pleura/haptics/standard_drivers.h>

namespace pleura::haptics {

namespace {

std::unique_ptr<HapticDevice> makeSimulated(const DeviceSettings& settings) {
  const auto& capabilities = settings.capabilities
                                 ? *settings.capabilities
                                 : devicePreset(settings.model.empty() ? "Touch" : settings.model);
  auto path = !settings.file.empty()       ? readStylusPath(settings.file)
              : settings.waypoints.empty() ? StylusPath()
                                           : StylusPath(settings.waypoints);
  return std::make_unique<SimulatedStylus>(capabilities, std::move(path),
                                           StylusHand{settings.handStiffness, settings.handDamping});
}

std::unique_ptr<HapticDevice> makeRecorded(const DeviceSettings& settings) {
  if (settings.file.empty()) throw DeviceError("the driver \"recorded\" needs the file of a recording");
  return std::make_unique<RecordedDevice>(readRecording(settings.file));
}

}  // namespace

DeviceRegistry standardDrivers() {
  DeviceRegistry drivers;
  drivers.add("simulated", makeSimulated);
  drivers.add("recorded", makeRecorded);
  drivers.add("phantom",
              [](const DeviceSettings& settings) { return std::make_unique<PhantomDevice>(settings.model); });
  return drivers;
}

}  // namespace pleura::haptics
