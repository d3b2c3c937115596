#include <gtest/gtest.h>

#include <pleura/nodes/lung/mechanics/orifice.h>

namespace pleura {
namespace {

const Orifice kHole{.area = 1e-5};
constexpr double kRho = 1.14;

TEST(Orifice, FlowsByTheSquareRootOfPressure) {
  for (double dp = 1; dp < 1e5; dp *= 3) {
    const double q = 0.6 * 1e-5 * std::sqrt(2 * dp / kRho);
    EXPECT_NEAR(orificeFlow(kHole, dp, kRho).q, q, 0.003 * q) << dp;
  }
}

TEST(Orifice, FlowsAlikeBothWaysAndNotAtAllWithoutPressure) {
  for (const double dp : {1e-9, 0.1, 490.0})
    EXPECT_EQ(orificeFlow(kHole, -dp, kRho).q, -orificeFlow(kHole, dp, kRho).q);
  EXPECT_EQ(orificeFlow(kHole, 0, kRho).q, 0);
  EXPECT_EQ(orificeFlow({.area = 0}, 490, kRho).q, 0);
}

TEST(Orifice, SlopeIsTheDerivative) {
  for (double dp = -2; dp <= 2; dp += 0.0503) {
    const double h = 1e-5, q = orificeFlow(kHole, dp + h, kRho).q - orificeFlow(kHole, dp - h, kRho).q;
    const double slope = orificeFlow(kHole, dp, kRho).slope;
    EXPECT_NEAR(slope, q / (2 * h), 1e-7 * slope) << dp;
    EXPECT_GT(slope, 0);
  }
}

}  // namespace
}  // namespace pleura
