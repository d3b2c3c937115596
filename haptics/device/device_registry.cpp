#include <fmt/format.h>
#include <fmt/ranges.h>

#include <pleura/fields/nearest_name.h>
#include <pleura/haptics/device/device_registry.h>

namespace pleura::haptics {

void DeviceRegistry::add(std::string driver, Factory factory) {
  drivers_.insert_or_assign(std::move(driver), std::move(factory));
}

const DeviceRegistry::Factory* DeviceRegistry::find(std::string_view driver) const {
  for (const auto& [name, factory] : drivers_)
    if (isSameName(name, driver)) return &factory;
  return nullptr;
}

void DeviceRegistry::check(std::string_view driver) const {
  if (find(driver) != nullptr) return;
  const auto known = names();
  throw DeviceError(fmt::format("no driver \"{}\" of haptic devices, known are {}{}", driver,
                                fmt::join(known, ", "), didYouMean(nearestName(driver, known))));
}

std::unique_ptr<HapticDevice> DeviceRegistry::make(std::string_view driver,
                                                   const DeviceSettings& settings) const {
  check(driver);
  return (*find(driver))(settings);
}

std::vector<std::string_view> DeviceRegistry::names() const {
  std::vector<std::string_view> all;
  for (const auto& [name, factory] : drivers_) all.push_back(name);
  return all;
}

}  // namespace pleura::haptics
