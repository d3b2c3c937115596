#include <cstdlib>
#include <limits>
#include <memory>
#include <thread>

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/haptics/phantom/phantom_device.h>
#include <pleura/tests/haptics/phantom/stand_in_hd.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

constexpr char kStandIn[] = PLEURA_TEST_PLUGINS "/libpleura_test_hd.so";
constexpr char kIncomplete[] = PLEURA_TEST_PLUGINS "/libpleura_test_hd_incomplete.so";

/// A process in which the stand-in is the vendor's library.
class Phantom : public ::testing::Test {
 protected:
  Phantom() {
    ::setenv("PLEURA_HD_LIBRARY", kStandIn, 1);
    void* library = dlopen(kStandIn, RTLD_NOW);
    hd_ = reinterpret_cast<StandInState>(dlsym(library, "stand_in_state"))();
    tick_ = reinterpret_cast<StandInTick>(dlsym(library, "stand_in_tick"));
    *hd_ = {};
  }
  ~Phantom() override {
    device_.close();
    EXPECT_EQ(hd_->misuses, 0) << "calls that HD doesn't allow";
    ::unsetenv("PLEURA_HD_LIBRARY");
  }

  std::string faultOfOpening() {
    try {
      device_.open();
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "none";
  }
  Vector3d givenForce() const { return {hd_->force[0], hd_->force[1], hd_->force[2]}; }

  StandInHd* hd_;
  StandInTick tick_;
  PhantomDevice device_;
  DeviceState state_;
};

TEST_F(Phantom, TellsMetresAboutTheMiddleOfItsWorkspace) {
  device_.open();
  hd_->transform[12] = 10;
  hd_->transform[13] = 30;
  hd_->transform[14] = -20;
  hd_->velocity[1] = 250;
  hd_->buttons = 2;
  tick_();
  ASSERT_TRUE(device_.read(0, state_));
  EXPECT_TRUE(state_.position.isApprox(Vector3d(0.010, 0.020, -0.020)));  // the middle is at y = 10 mm
  EXPECT_TRUE(state_.velocity.isApprox(Vector3d(0, 0.25, 0)));
  EXPECT_EQ(state_.buttons, 2u);
}

TEST_F(Phantom, TurnsAsTheGimbal) {
  device_.open();
  // A quarter turn about y, column by column.
  const double quarter[12] = {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0};
  std::copy(std::begin(quarter), std::end(quarter), hd_->transform);
  tick_();
  ASSERT_TRUE(device_.read(0, state_));
  EXPECT_TRUE((state_.orientation * Vector3d::UnitX()).isApprox(-Vector3d::UnitZ(), 1e-12));
  EXPECT_TRUE((state_.orientation * Vector3d::UnitY()).isApprox(Vector3d::UnitY(), 1e-12));
}

TEST_F(Phantom, KnowsWhatTheDeviceCanDo) {
  EXPECT_EQ(device_.capabilities().model, "Touch");
  device_.open();
  const auto& capabilities = device_.capabilities();
  EXPECT_EQ(capabilities.model, "PHANTOM Omni");
  EXPECT_NEAR(capabilities.maxForce, 3.3, 1e-12);
  EXPECT_NEAR(capabilities.maxStiffness, 500, 1e-9);
  EXPECT_NEAR(capabilities.maxDamping, 4, 1e-12);
  EXPECT_NEAR(capabilities.workspaceRadius, 0.040, 1e-12);
  EXPECT_EQ(capabilities.buttons, 2);  // the preset's
  EXPECT_EQ(hd_->configuration, "(default)");
}

TEST_F(Phantom, WhatHdDoesNotTellIsThePresets) {
  hd_->maxForce = 0;
  hd_->maxStiffness = -1;
  hd_->maxDamping = std::numeric_limits<double>::quiet_NaN();
  std::fill(std::begin(hd_->workspace), std::end(hd_->workspace), 0.0);
  device_.open();
  EXPECT_EQ(device_.capabilities().maxForce, 3.3);
  EXPECT_EQ(device_.capabilities().maxStiffness, 700);
  EXPECT_EQ(device_.capabilities().maxDamping, 5);
  EXPECT_EQ(device_.capabilities().workspaceRadius, 0.10);
}

TEST_F(Phantom, OpensTheConfigurationThatWasNamed) {
  PhantomDevice left("Left");
  left.open();
  EXPECT_EQ(hd_->configuration, "Left");
}

TEST_F(Phantom, GivesForcesWithinItsLimit) {
  device_.open();
  EXPECT_TRUE(device_.write({.force = {1, -0.5, 2}}));
  tick_();
  EXPECT_EQ(givenForce(), Vector3d(1, -0.5, 2));
  device_.write({.force = {0, 100, 0}});
  tick_();
  EXPECT_TRUE(givenForce().isApprox(Vector3d(0, 3.3, 0)));
  device_.write({.force = {0, std::numeric_limits<double>::quiet_NaN(), 0}});
  tick_();
  EXPECT_EQ(givenForce(), Vector3d::Zero());
}

TEST_F(Phantom, ALoopThatStopsWritingLosesItsForce) {
  device_.open();
  device_.write({.force = {1, 0, 0}});
  for (int tick = 0; tick <= 20; ++tick) {
    tick_();
    EXPECT_EQ(givenForce(), Vector3d(1, 0, 0));
  }
  tick_();
  EXPECT_EQ(givenForce(), Vector3d::Zero());
  device_.write({.force = {1, 0, 0}});
  tick_();
  EXPECT_EQ(givenForce(), Vector3d(1, 0, 0));
}

TEST_F(Phantom, CalibratesWhenTheDeviceAsksForIt) {
  device_.open();
  hd_->needsCalibration = true;
  tick_();
  tick_();
  EXPECT_EQ(hd_->calibrations, 1);
}

TEST_F(Phantom, ClosedItHasNoForceAndNoCallback) {
  device_.open();
  device_.write({.force = {1, 0, 0}});
  tick_();
  device_.close();
  device_.close();
  EXPECT_FALSE(hd_->isOpen);
  EXPECT_FALSE(hd_->isSchedulerRunning);
  EXPECT_EQ(hd_->callback, nullptr);
  EXPECT_EQ(givenForce(), Vector3d::Zero());
  EXPECT_FALSE(device_.read(0, state_));
  EXPECT_FALSE(device_.write({}));
}

TEST_F(Phantom, AMissingLibrarySaysWhatToDo) {
  ::setenv("PLEURA_HD_LIBRARY", "/missing/libHD.so", 1);
  EXPECT_THAT(faultOfOpening(),
              ::testing::AllOf(HasSubstr("/missing/libHD.so"), HasSubstr("install OpenHaptics")));
  ::setenv("PLEURA_HD_LIBRARY", "", 1);
  EXPECT_EQ(hd::libraryPath(), "libHD.so");
}

TEST_F(Phantom, AMissingSymbolIsNamed) {
  ::setenv("PLEURA_HD_LIBRARY", kIncomplete, 1);
  EXPECT_THAT(faultOfOpening(), HasSubstr("it lacks hdEndFrame"));
}

TEST_F(Phantom, ADeviceThatIsNotThereSaysWhyAndMayBeTriedAgain) {
  hd_->isAbsent = true;
  EXPECT_THAT(faultOfOpening(),
              HasSubstr("can't be opened: Device fault (HD error 0x0300, 7): is it plugged in"));
  hd_->isAbsent = false;
  EXPECT_EQ(faultOfOpening(), "none");
}

TEST_F(Phantom, AFailureAtEachStepOfOpeningLeavesNothingOpen) {
  hd_->errorAtInit = 0x0301;
  EXPECT_THAT(faultOfOpening(), HasSubstr("0x0301"));
  hd_->errorAtInit = 0;
  hd_->errorAtScheduler = hd::kDeviceFault;
  EXPECT_THAT(faultOfOpening(), HasSubstr("start its scheduler"));
  EXPECT_FALSE(hd_->isOpen);
  EXPECT_FALSE(hd_->isSchedulerRunning);
  hd_->errorAtScheduler = 0;
  hd_->transform[13] = std::numeric_limits<double>::infinity();
  EXPECT_THAT(faultOfOpening(), HasSubstr("can't tell where it is"));
  EXPECT_FALSE(hd_->isOpen);
  hd_->transform[13] = 0;
  EXPECT_EQ(faultOfOpening(), "none");
}

TEST_F(Phantom, WarmMotorsAreNoLoss) {
  device_.open();
  hd_->errorAtEndFrame = 0x0200;
  tick_();
  EXPECT_TRUE(device_.read(0, state_));
  tick_();
  EXPECT_TRUE(device_.read(0.001, state_));
}

TEST_F(Phantom, ADeviceThatDisappearsIsLostAndComesBack) {
  device_.open();
  device_.write({.force = {1, 0, 0}});
  tick_();
  EXPECT_TRUE(device_.read(0, state_));
  hd_->isAbsent = true;
  tick_();
  state_.position = {7, 7, 7};
  EXPECT_FALSE(device_.read(0.001, state_));
  EXPECT_EQ(state_.position, Vector3d(7, 7, 7));
  EXPECT_FALSE(device_.write({.force = {1, 0, 0}}));
  EXPECT_EQ(givenForce(), Vector3d::Zero());
  hd_->errors.clear();
  EXPECT_NE(faultOfOpening(), "none");

  hd_->isAbsent = false;
  hd_->errors.clear();
  device_.open();
  tick_();
  EXPECT_EQ(givenForce(), Vector3d::Zero());  // not that of before
  EXPECT_TRUE(device_.read(5, state_));
  device_.write({.force = {0, 1, 0}});
  tick_();
  EXPECT_EQ(givenForce(), Vector3d(0, 1, 0));
}

TEST_F(Phantom, AForceThatWasNotGivenYetIsForgottenWhenClosed) {
  device_.open();
  device_.write({.force = {1, 0, 0}});
  device_.close();
  device_.open();
  tick_();
  EXPECT_EQ(givenForce(), Vector3d::Zero());
}

TEST_F(Phantom, AStateThatIsNoNumberIsALossWithoutForce) {
  device_.open();
  device_.write({.force = {1, 0, 0}});
  tick_();
  hd_->transform[12] = std::numeric_limits<double>::quiet_NaN();
  tick_();
  EXPECT_FALSE(device_.read(0, state_));
  EXPECT_EQ(givenForce(), Vector3d::Zero());
}

TEST_F(Phantom, ATransformThatIsNoRotationIsALoss) {
  device_.open();
  std::fill(std::begin(hd_->transform), std::begin(hd_->transform) + 12, 40.0);
  tick_();
  EXPECT_FALSE(device_.read(0, state_));
}

TEST_F(Phantom, ASilentSchedulerIsALoss) {
  device_.open();
  tick_();
  EXPECT_TRUE(device_.read(10, state_));
  EXPECT_TRUE(device_.read(10.09, state_));
  tick_();
  EXPECT_TRUE(device_.read(10.15, state_));
  EXPECT_FALSE(device_.read(10.26, state_));
  // Should it wake up, it gives no force any more.
  tick_();
  EXPECT_FALSE(device_.read(10.27, state_));
  EXPECT_EQ(hd_->callback, nullptr);
}

TEST_F(Phantom, ErrorsWithoutEndAreALossNotAHang) {
  device_.open();
  hd_->errors.assign(100, {0x0201, 0, 1});
  tick_();
  EXPECT_FALSE(device_.read(0, state_));
  hd_->errors.clear();
}

TEST_F(Phantom, ASecondOneAtATimeIsRefused) {
  device_.open();
  PhantomDevice second;
  EXPECT_THROW(second.open(), DeviceError);
  tick_();
  EXPECT_TRUE(device_.read(0, state_));
  device_.close();
  EXPECT_NO_THROW(second.open());
}

TEST_F(Phantom, SchedulerAndLoopMayBeTwoThreads) {
  device_.open();
  std::thread scheduler([this] {
    for (int tick = 1; tick <= 5000; ++tick) {
      hd_->transform[12] = hd_->transform[14] = tick % 100;
      tick_();
    }
  });
  int torn = 0;
  for (int i = 0; i < 5000; ++i) {
    device_.write({.force = {1, 0, 0}});
    if (device_.read(0, state_)) torn += state_.position.x() == state_.position.z() ? 0 : 1;
  }
  scheduler.join();
  EXPECT_EQ(torn, 0);
}

}  // namespace
}  // namespace pleura::haptics
