#include "surfaces.h"
#include <gtest/gtest.h>

#include <pleura/haptics/contact/contact_force.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;
using surfaces::Touchable;

constexpr double period = 1e-3;

/// A floor at z = 0, and a ball of 1 mm that is led from 5 mm above to the device's place.
class ContactForce : public testing::Test {
 protected:
  ContactForce() : floor_(surfaces::sheet(0.1, 4, [](double, double) { return 0; })) {
    floor_.shape.surface = {.stiffness = 500, .damping = 2};
    proxy_.reset({0, 0, 0.005});
  }
  Vector3d forceAt(const Vector3d& device, const Vector3d& velocity = Vector3d::Zero()) {
    proxy_.follow(std::span(&floor_.shape, 1), device);
    return contactForce(proxy_, device, velocity, period);
  }
  static void expectNear(const Vector3d& a, const Vector3d& b) {
    EXPECT_LT((a - b).norm(), 1e-6) << a.transpose();
  }

  Touchable floor_;
  Proxy proxy_{1e-3};
};

TEST_F(ContactForce, IsNothingInTheAir) { EXPECT_EQ(forceAt({0, 0, 0.002}, {1, 2, 3}), Vector3d::Zero()); }

TEST_F(ContactForce, IsStiffnessTimesDepth) { expectNear(forceAt({0.01, 0, -0.001}), {0, 0, 500 * 0.002}); }

TEST_F(ContactForce, DampsAlongTheNormalOnly) {
  expectNear(forceAt({0.01, 0, -0.001}, {0.3, 0, -0.1}), {0, 0, 500 * 0.002 + 2 * 0.1});
}

TEST_F(ContactForce, NeverPulls) { expectNear(forceAt({0.01, 0, -0.001}, {0, 0, 10}), {0, 0, 0}); }

TEST_F(ContactForce, DampsWhatGoesAgainstTheSurface) {
  forceAt({0, 0, -0.001});
  floor_.shape.pose.translation().z() += 1e-4;  // at 0.1 m/s
  expectNear(forceAt({0, 0, -0.001}), {0, 0, 500 * 0.0021 + 2 * 0.1});
}

TEST_F(ContactForce, HoldsByFrictionWithinTheCone) {
  floor_.shape.surface.staticFriction = 0.5;
  floor_.shape.surface.dynamicFriction = 0.25;
  expectNear(forceAt({0, 0, -0.001}), {0, 0, 1});
  expectNear(forceAt({0.0009, 0, -0.001}), {-0.45, 0, 1});
  expectNear(forceAt({0.0011, 0, -0.001}), {-0.25, 0, 1});
}

TEST_F(ContactForce, PullsToAMagneticSurface) {
  floor_.shape.surface.magneticDistance = 0.003;
  forceAt({0, 0, 0.0005});
  expectNear(forceAt({0, 0, 0.003}), {0, 0, -500 * 0.002});
  expectNear(forceAt({0, 0, 0.0042}), {0, 0, 0});
}

}  // namespace
}  // namespace pleura::haptics
