#include <limits>

#include <gtest/gtest.h>

#include <pleura/haptics/safety/force_limiter.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;

TEST(ForceLimiter, WhatIsWithinTheLimitIsKeptBitForBit) {
  const Vector3d force(0.1, -0.7, 1.3);
  EXPECT_EQ(limited(force, 3), force);
  EXPECT_EQ(limited(Vector3d(0, 3, 0), 3), Vector3d(0, 3, 0));
  EXPECT_EQ(limited(Vector3d::Zero(), 0), Vector3d::Zero());
}

TEST(ForceLimiter, WhatIsBeyondKeepsItsDirection) {
  EXPECT_TRUE(limited({30, 0, -40}, 5).isApprox(Vector3d(3, 0, -4), 1e-15));
  EXPECT_EQ(limited({1, 2, 3}, 0), Vector3d::Zero());
}

TEST(ForceLimiter, TheGreatestAndTheLeastNumbersDoNotOverflow) {
  constexpr double kMost = std::numeric_limits<double>::max(), kLeast = std::numeric_limits<double>::min();
  EXPECT_TRUE(limited({kMost, -kMost, kMost}, 3).isApprox(Vector3d(1, -1, 1) * std::sqrt(3.0), 1e-15));
  EXPECT_EQ(limited({kLeast, 0, 0}, 3), Vector3d(kLeast, 0, 0));
}

TEST(ForceLimiter, WhatIsNoNumberIsNoForce) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(limited({1, kNan, 1}, 3), Vector3d::Zero());
  EXPECT_EQ(limited({1, 1, kInfinity}, 3), Vector3d::Zero());
  EXPECT_EQ(limited({-kInfinity, 1, 1}, 3), Vector3d::Zero());
}

}  // namespace
}  // namespace pleura::haptics
