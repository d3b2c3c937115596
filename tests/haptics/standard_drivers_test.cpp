#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/haptics/standard_drivers.h>

namespace pleura::haptics {
namespace {

TEST(StandardDrivers, ASimulatedStylusNeedsNoSettings) {
  const auto device = standardDrivers().make("simulated", {});
  EXPECT_EQ(device->capabilities().model, "Touch");
  device->open();
  DeviceState state;
  EXPECT_TRUE(device->read(0, state));
  EXPECT_EQ(state.position, Eigen::Vector3d::Zero());
}

TEST(StandardDrivers, APresetOrOwnCapabilitiesDescribeTheSimulatedStylus) {
  const auto drivers = standardDrivers();
  EXPECT_EQ(drivers.make("simulated", {.model = "falcon"})->capabilities().maxStiffness, 3000);
  DeviceCapabilities own{
      .model = "own", .maxForce = 1, .maxStiffness = 10, .workspaceRadius = 0.1, .mass = 0.2};
  EXPECT_EQ(drivers.make("simulated", {.capabilities = own})->capabilities().mass, 0.2);
  EXPECT_THROW(drivers.make("simulated", {.model = "nothing like it"}), DeviceError);
  EXPECT_THROW(drivers.make("simulated", {.handStiffness = -1}), DeviceError);
}

TEST(StandardDrivers, ARecordingNeedsItsFile) {
  EXPECT_THROW(standardDrivers().make("recorded", {}), DeviceError);
  EXPECT_THROW(standardDrivers().make("recorded", {.file = "/missing"}), DeviceError);
}

}  // namespace
}  // namespace pleura::haptics
