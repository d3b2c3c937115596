#include <algorithm>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <pleura/nodes/lung/mechanics/recoil_curve.h>

namespace pleura {
namespace {

TEST(RecoilCurve, BothFormsPassThroughRestWithItsCompliance) {
  const RestingLung rest;
  for (const RecoilCurve& curve :
       {RecoilCurve::linear(), RecoilCurve::sigmoid(), RecoilCurve::sigmoid(rest, 3e-4)}) {
    EXPECT_NEAR(curve.volume(rest.recoil), rest.volume, 1e-15);
    EXPECT_NEAR(curve.compliance(rest.recoil), rest.compliance, 1e-18);
  }
}

TEST(RecoilCurve, ComplianceIsTheSlope) {
  for (const RecoilCurve& curve : {RecoilCurve::linear(), RecoilCurve::sigmoid()})
    for (double P = -20 * kCmH2O; P < 40 * kCmH2O; P += 93) {
      const double slope = (curve.volume(P + 0.1) - curve.volume(P - 0.1)) / 0.2;
      EXPECT_NEAR(curve.compliance(P), slope, 1e-13) << P;
    }
}

TEST(RecoilCurve, NeverNegativeNeverFallingAtAnyPressure) {
  for (const RecoilCurve& curve :
       {RecoilCurve::linear(), RecoilCurve::sigmoid(), RecoilCurve::sigmoid({}, 1e-4)}) {
    double last = 0;
    for (const double P : {-1e300, -1e9, -1e5, -1e3, -500.0, 0.0, 500.0, 1e3, 1e5}) {
      EXPECT_GE(curve.volume(P), std::max(last, curve.leastVolume())) << P;
      EXPECT_GE(curve.compliance(P), 0) << P;
      last = curve.volume(P);
    }
  }
}

TEST(RecoilCurve, TheSigmoidEndsAtItsLimits) {
  const RecoilCurve curve = RecoilCurve::sigmoid({}, 2e-4, 3e-3);
  EXPECT_DOUBLE_EQ(curve.volume(-1e6), 2e-4);
  EXPECT_DOUBLE_EQ(curve.volume(1e6), 3e-3);
  EXPECT_EQ(curve.leastVolume(), 2e-4);
}

TEST(RecoilCurve, AnUnstretchedLungIsSmallerThanAtRest) {
  EXPECT_NEAR(RecoilCurve::linear().volume(0), 0.65 * kLitre, 1e-12);  // 1.15 - 0.1 * 5
  EXPECT_GT(RecoilCurve::sigmoid().volume(0), 0.65 * kLitre);
  EXPECT_LT(RecoilCurve::sigmoid().volume(0), 0.75 * kLitre);
}

TEST(RecoilCurve, NumbersThatMakeNoLungAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {nan, -1.0, 0.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(RecoilCurve::linear({.volume = bad}), std::invalid_argument);
    EXPECT_THROW(RecoilCurve::linear({.recoil = bad}), std::invalid_argument);
    EXPECT_THROW(RecoilCurve::sigmoid({.compliance = bad}), std::invalid_argument);
  }
  EXPECT_THROW(RecoilCurve::sigmoid({}, 1.2 * kLitre), std::invalid_argument);
  EXPECT_THROW(RecoilCurve::sigmoid({}, 0, 1.1 * kLitre), std::invalid_argument);
  EXPECT_THROW(RecoilCurve::sigmoid({}, -1e-9), std::invalid_argument);
  EXPECT_THROW(RecoilCurve::sigmoid({}, nan), std::invalid_argument);
  EXPECT_THROW(RecoilCurve::sigmoid({}, 0, nan), std::invalid_argument);
}

}  // namespace
}  // namespace pleura
