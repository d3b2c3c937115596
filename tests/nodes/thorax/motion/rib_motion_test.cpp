#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include <pleura/nodes/thorax/motion/rib_motion.h>

namespace pleura {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Pump and bucket of R = Rz(b) Rx(-a), read off its axes.
double pumpOf(const Eigen::Matrix3d& r) { return std::atan2(-r(2, 1), r(2, 2)); }
double bucketOf(const Eigen::Matrix3d& r) { return std::atan2(r(1, 0), r(0, 0)); }

TEST(RibMotion, TurnsByTheMeasuredAnglesAtTotalLungCapacity) {
  // Wilson et al. 2001, ribs 2-9, degrees
  constexpr double kPump[] = {14.3, 11.4, 10.7, 9.6, 9.4, 7.9, 7.9, 6.0};
  constexpr double kBucket[] = {13.7, 13.3, 10.1, 8.9, 6.9, 6.6, 6.2, 6.3};
  for (const double side : {1.0, -1.0}) {
    for (std::size_t k = 0; k < 8; ++k) {
      const Eigen::Matrix3d r = ribRotation(measuredRibAngles(side)[k + 1], 1.0);
      EXPECT_NEAR(pumpOf(r), kPump[k] * kDegree, 1e-12);
      EXPECT_NEAR(bucketOf(r), side * kBucket[k] * kDegree, 1e-12);
    }
  }
}

TEST(RibMotion, TurnsInProportionToInflation) {
  const RibAngles angles = measuredRibAngles(1.0)[4];
  for (const double inflation : {0.1, 1.0 / 7.0, 0.5}) {
    const Eigen::Matrix3d r = ribRotation(angles, inflation);
    EXPECT_NEAR(pumpOf(r), inflation * angles.pump, 1e-12);
    EXPECT_NEAR(bucketOf(r), inflation * angles.bucket, 1e-12);
  }
}

TEST(RibMotion, InhalationRaisesTheFrontAndMovesTheSideOutwards) {
  for (const double side : {1.0, -1.0}) {
    for (const RibAngles& angles : measuredRibAngles(side)) {
      const Eigen::Matrix3d r = ribRotation(angles, 1.0);
      const Eigen::Vector3d front(side * 0.03, -0.06, 0.12);    // from the head, down and forwards
      const Eigen::Vector3d lateral(side * 0.10, -0.05, 0.02);  // down and outwards
      EXPECT_GT((r * front).y(), front.y());
      EXPECT_GT(side * (r * lateral).x(), side * lateral.x());
      EXPECT_GT((r * lateral).y(), lateral.y());
    }
  }
}

TEST(RibMotion, TheTwoSidesMirror) {
  const Eigen::Vector3d p(0.08, -0.03, 0.05);
  const Eigen::Vector3d mirrored(-p.x(), p.y(), p.z());
  for (std::size_t k = 0; k < 12; ++k) {
    const Eigen::Vector3d left = ribRotation(measuredRibAngles(1.0)[k], 0.7) * p;
    const Eigen::Vector3d right = ribRotation(measuredRibAngles(-1.0)[k], 0.7) * mirrored;
    EXPECT_LT((left - Eigen::Vector3d(-right.x(), right.y(), right.z())).norm(), 1e-15);
  }
}

TEST(RibMotion, KeepsTheHeadAndReturnsExactlyToRest) {
  const Eigen::Vector3d head(0.014, 0.163, 0.028);
  const Eigen::Isometry3d moved = rotationAbout(ribRotation(thesisRibAngles(1.0)[1], 0.8), head);
  EXPECT_LT((moved * head - head).norm(), 1e-15);
  const Eigen::Isometry3d rest = rotationAbout(ribRotation(thesisRibAngles(1.0)[1], 0.0), head);
  EXPECT_EQ(rest.matrix(), Eigen::Matrix4d::Identity());
}

TEST(RibMotion, KnowsTheThesisAmplitudes) {
  EXPECT_DOUBLE_EQ(thesisRibAngles(1.0)[0].pump, 0.19);
  EXPECT_DOUBLE_EQ(thesisRibAngles(1.0)[4].bucket, 0.19);
  EXPECT_DOUBLE_EQ(thesisRibAngles(-1.0)[10].bucket, 0.24);
  EXPECT_DOUBLE_EQ(thesisRibAngles(-1.0)[10].side, -1.0);
}

TEST(RibMotion, RefusesWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(ribRotation({nan, 0.1, 1.0}, 0.5), std::invalid_argument);
  EXPECT_THROW(ribRotation({0.1, infinity, 1.0}, 0.5), std::invalid_argument);
  EXPECT_THROW(ribRotation({0.1, 0.1, nan}, 0.5), std::invalid_argument);
  EXPECT_THROW(ribRotation({0.1, 0.1, 1.0}, infinity), std::invalid_argument);
}

}  // namespace
}  // namespace pleura
