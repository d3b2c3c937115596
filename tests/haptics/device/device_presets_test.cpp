#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/haptics/device/device_presets.h>
#include <pleura/haptics/device/haptic_device.h>

namespace pleura::haptics {
namespace {

TEST(DevicePresets, EachIsPossibleAndFoundByItsName) {
  EXPECT_EQ(devicePresets().size(), 10u);
  for (const auto& preset : devicePresets()) {
    EXPECT_NO_THROW(preset.check());
    EXPECT_EQ(&devicePreset(preset.model), &preset);
  }
}

TEST(DevicePresets, CaseDoesNotMatter) { EXPECT_EQ(devicePreset("PREMIUM 1.5").model, "Premium 1.5"); }

TEST(DevicePresets, AnUnknownNameIsToldTheNearestKnownOne) {
  try {
    devicePreset("omnii");
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith("no haptic device \"omnii\", known are Touch, Omni,"));
    EXPECT_THAT(error.what(), ::testing::EndsWith("; did you mean Omni?"));
  }
}

TEST(DevicePresets, ANameLikeNoneIsToldTheKnownOnesOnly) {
  for (const std::string& name : {std::string(), std::string("stylophone"), std::string(100'000, 'o')}) {
    try {
      devicePreset(name);
      FAIL();
    } catch (const DeviceError& error) {
      EXPECT_THAT(error.what(), ::testing::EndsWith("lambda.7"));
    }
  }
}

}  // namespace
}  // namespace pleura::haptics
