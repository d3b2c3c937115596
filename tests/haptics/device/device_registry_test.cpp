#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/haptics/device/device_presets.h>
#include <pleura/haptics/device/device_registry.h>

namespace pleura::haptics {
namespace {

class NamedDevice : public HapticDevice {
 public:
  explicit NamedDevice(std::string model) { capabilities_.model = std::move(model); }
  const DeviceCapabilities& capabilities() const override { return capabilities_; }
  void open() override {}
  void close() noexcept override {}
  bool read(double, DeviceState&) noexcept override { return true; }
  bool write(const DeviceForce&) noexcept override { return true; }

 private:
  DeviceCapabilities capabilities_;
};

DeviceRegistry::Factory makes(const std::string& prefix) {
  return [prefix](const DeviceSettings& of) { return std::make_unique<NamedDevice>(prefix + of.model); };
}

TEST(DeviceRegistry, TheFactoryOfTheNameGetsTheSettings) {
  DeviceRegistry registry;
  registry.add("one", makes("1:"));
  registry.add("two", makes("2:"));
  EXPECT_EQ(registry.make("Two", {.model = "x"})->capabilities().model, "2:x");
  EXPECT_THAT(registry.names(), ::testing::ElementsAre("one", "two"));
}

TEST(DeviceRegistry, TheDriverAddedLastCounts) {
  DeviceRegistry registry;
  registry.add("one", makes("old:"));
  registry.add("one", makes("new:"));
  EXPECT_EQ(registry.make("one", {})->capabilities().model, "new:");
}

TEST(DeviceRegistry, AnUnknownDriverIsToldTheNearestKnownOne) {
  DeviceRegistry registry;
  registry.add("simulated", makes(""));
  try {
    registry.make("simulatd", {});
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_STREQ(error.what(),
                 "no driver \"simulatd\" of haptic devices, known are simulated; did you mean simulated?");
  }
}

}  // namespace
}  // namespace pleura::haptics
