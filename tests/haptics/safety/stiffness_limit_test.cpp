#include <limits>

#include <gtest/gtest.h>

#include <pleura/haptics/safety/stiffness_limit.h>

namespace pleura::haptics {
namespace {

TEST(StiffnessLimit, OfTheLoopsOfLiterature) {
  EXPECT_NEAR(stiffnessLimit(0.2, 0, 0.001), 400, 1e-9);
  EXPECT_NEAR(stiffnessLimit(0.2, 0, 1.0 / 30), 12, 1e-9);
  EXPECT_NEAR(stiffnessLimit(0.2, 0, 1 / 2.5), 1, 1e-9);
}

TEST(StiffnessLimit, RenderedDampingOfEitherSignCostsStiffness) {
  EXPECT_NEAR(stiffnessLimit(0.2, 0.05, 0.001), 300, 1e-9);
  EXPECT_NEAR(stiffnessLimit(0.2, -0.05, 0.001), 300, 1e-9);
  EXPECT_EQ(stiffnessLimit(0.2, 0.3, 0.001), 0);
}

TEST(StiffnessLimit, DampingLimitIsItsOtherSide) {
  EXPECT_NEAR(dampingLimit(0.2, 300, 0.001), 0.05, 1e-12);
  EXPECT_NEAR(stiffnessLimit(0.2, dampingLimit(0.2, 123, 0.001), 0.001), 123, 1e-9);
  EXPECT_EQ(dampingLimit(0.2, 1000, 0.001), 0);
}

TEST(StiffnessLimit, EncoderStepsNeedFriction) {
  EXPECT_NEAR(quantizationStiffnessLimit(0.02, 5e-5), 800, 1e-9);
  EXPECT_EQ(quantizationStiffnessLimit(0.02, 0), std::numeric_limits<double>::infinity());
}

TEST(StiffnessLimit, ADevicesIsTheLeastOfAll) {
  DeviceCapabilities device{
      .model = "own", .maxStiffness = 1000, .damping = 0.2, .friction = 0.02, .encoderStep = 1e-4};
  EXPECT_NEAR(stiffnessLimit(device, 0, 0.001), 400, 1e-9);
  device.damping = 1;
  EXPECT_NEAR(stiffnessLimit(device, 0, 0.001), 400, 1e-9);  // 2 f_c / Delta
  device.friction = 0.2;
  EXPECT_EQ(stiffnessLimit(device, 0, 0.001), 1000);
  device.friction = 0;  // unknown
  EXPECT_EQ(stiffnessLimit(device, 0, 0.001), 1000);
}

}  // namespace
}  // namespace pleura::haptics
