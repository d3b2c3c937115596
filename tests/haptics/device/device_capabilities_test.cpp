#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/haptics/device/device_presets.h>
#include <pleura/haptics/device/haptic_device.h>

namespace pleura::haptics {
namespace {

using ::testing::HasSubstr;

std::string faultAfter(void (*change)(DeviceCapabilities&)) {
  DeviceCapabilities capabilities = devicePreset("Touch");
  change(capabilities);
  try {
    capabilities.check();
  } catch (const DeviceError& error) {
    return error.what();
  }
  return {};
}

TEST(DeviceCapabilities, PossibleFiguresPass) {
  EXPECT_EQ(faultAfter([](DeviceCapabilities&) {}), "");
  EXPECT_EQ(faultAfter([](DeviceCapabilities& of) { of.damping = of.friction = of.encoderStep = 0; }), "");
}

TEST(DeviceCapabilities, AFaultNamesTheDeviceTheFigureAndWhatWasExpected) {
  const std::string fault = faultAfter([](DeviceCapabilities& of) { of.mass = -1; });
  EXPECT_EQ(fault, "device \"Touch\": mass is -1, expected more than 0 and at most 1e+09");
}

TEST(DeviceCapabilities, FiguresThatCanNotBeAreRefused) {
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.maxForce = 0; }), HasSubstr("maxForce"));
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.maxTorque = -1; }), HasSubstr("maxTorque"));
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.maxStiffness = 0; }), HasSubstr("maxStiffness"));
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.maxDamping = -1; }), HasSubstr("maxDamping"));
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.workspaceRadius = 0; }),
              HasSubstr("workspaceRadius"));
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.mass = 0; }), HasSubstr("mass"));
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.damping = -0.1; }), HasSubstr("damping"));
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.friction = -0.1; }), HasSubstr("friction"));
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.encoderStep = -1; }), HasSubstr("encoderStep"));
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.inputDof = 2; }), HasSubstr("inputDof"));
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.outputDof = 8; }), HasSubstr("outputDof"));
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.buttons = 33; }), HasSubstr("buttons"));
}

TEST(DeviceCapabilities, WhatIsNotFiniteIsRefused) {
  EXPECT_THAT(faultAfter([](DeviceCapabilities& of) { of.mass = std::numeric_limits<double>::quiet_NaN(); }),
              HasSubstr("mass is nan"));
  EXPECT_THAT(
      faultAfter([](DeviceCapabilities& of) { of.damping = std::numeric_limits<double>::infinity(); }),
      HasSubstr("damping is inf"));
}

}  // namespace
}  // namespace pleura::haptics
