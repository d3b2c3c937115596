#include <fmt/format.h>

#include <pleura/haptics/device/device_presets.h>
#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/haptic/simulated_device.h>

namespace pleura {

void SimulatedDevice::declare(NodeType& type) {
  HapticsDeviceNode::declare(type);
  type.named("SimulatedDevice", "Pleura").means("a stylus that is simulated, in a hand that follows a path");
  using enum Access;
  type.field<&SimulatedDevice::model>("model", initializeOnly, "Premium 3.0")
      .means("the device that it stands in for: Touch, Omni, Premium 1.5, Premium 3.0, Falcon, omega, ...");
  type.field<&SimulatedDevice::url>("url", initializeOnly, {})
      .means("the hand's path, a CSV file of time, x, y, z [s, m] in the device's frame");
  type.field<&SimulatedDevice::key>("key", initializeOnly, {})
      .measuredIn(Unit::time)
      .means("times of keyValue, when there is no url");
  type.field<&SimulatedDevice::keyValue>("keyValue", initializeOnly, {})
      .measuredIn(Unit::length)
      .means("where the hand wants the tip to be at each key, in the device's frame");
  type.field<&SimulatedDevice::handStiffness>("handStiffness", initializeOnly, 200)
      .atLeast(0)
      .means("of the hand's grip [N/m]");
  type.field<&SimulatedDevice::handDamping>("handDamping", initializeOnly, 2)
      .atLeast(0)
      .means("of the hand's grip [N s/m]");
  type.field<&SimulatedDevice::mass>("mass", initializeOnly, -1)
      .measuredIn(Unit::mass)
      .means("felt at the tip; -1: the model's");
  type.field<&SimulatedDevice::damping>("damping", initializeOnly, -1)
      .means("of the mechanism [N s/m]; -1: the model's");
  type.field<&SimulatedDevice::friction>("friction", initializeOnly, -1)
      .measuredIn(Unit::force)
      .means("Coulomb friction at the tip; -1: the model's");
  type.field<&SimulatedDevice::encoderStep>("encoderStep", initializeOnly, -1)
      .measuredIn(Unit::length)
      .means("from one position that is told to the next; -1: the model's");
}

void SimulatedDevice::onInitialize() {
  try {
    settings();
  } catch (const haptics::DeviceError& refused) {
    context().warn(*this, refused.what());
  }
}

haptics::DeviceSettings SimulatedDevice::settings() {
  haptics::DeviceSettings settings;
  settings.model = model.getValue(id);
  haptics::DeviceCapabilities figures = haptics::devicePreset(settings.model);
  const auto take = [this](SFFloat& field, double& figure) {
    if (field.getValue(id) >= 0) figure = field.getValue(id);
  };
  take(mass, figures.mass);
  take(damping, figures.damping);
  take(friction, figures.friction);
  take(encoderStep, figures.encoderStep);
  settings.capabilities = figures;
  settings.handStiffness = handStiffness.getValue(id);
  settings.handDamping = handDamping.getValue(id);
  const auto& times = key.getValue(id);
  const auto& places = keyValue.getValue(id);
  if (times.size() != places.size())
    throw haptics::DeviceError(
        fmt::format("{} values of key, but {} of keyValue", times.size(), places.size()));
  for (std::size_t i = 0; i < times.size(); ++i)
    settings.waypoints.push_back({.time = times[i], .position = places[i].cast<double>()});
  return settings;
}

std::string SimulatedDevice::file() {
  const auto& urls = url.getValue(id);
  return urls.empty() ? std::string() : urls.front();
}

}  // namespace pleura
