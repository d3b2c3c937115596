#include <fmt/format.h>
#include <fmt/ranges.h>

#include <pleura/haptics/device/device_registry.h>
#include <pleura/haptics/device/nearest_name.h>

namespace pleura::haptics {

void DeviceRegistry::add(std::string driver, Factory factory) {
  drivers_.insert_or_assign(std::move(driver), std::move(factory));
}

std::unique_ptr<HapticDevice> DeviceRegistry::make(std::string_view driver,
                                                   const DeviceSettings& settings) const {
  for (const auto& [name, factory] : drivers_)
    if (isSameName(name, driver)) return factory(settings);
  const auto known = names();
  throw DeviceError(fmt::format("no driver \"{}\" of haptic devices, known are {}{}", driver,
                                fmt::join(known, ", "), didYouMean(driver, known)));
}

std::vector<std::string_view> DeviceRegistry::names() const {
  std::vector<std::string_view> all;
  for (const auto& [name, factory] : drivers_) all.push_back(name);
  return all;
}

}  // namespace pleura::haptics
