#include <array>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/nodes/thorax/motion/skin.h>

namespace pleura {
namespace {

Eigen::Isometry3d turn(double angle, const Eigen::Vector3d& shift) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  motion.translation() = shift;
  return motion;
}

const std::array<Eigen::Isometry3d, 2> kMotions{turn(0.3, {0.01, 0.02, 0.0}), turn(-0.2, {0.0, -0.05, 0.01})};
const std::array<BodyDisplacement, 2> kDisplacements{displacementOf(kMotions[0]),
                                                     displacementOf(kMotions[1])};
const Eigen::Vector3f kPoint(0.12f, -0.07f, 0.09f);

Eigen::Vector3d carried(const BodyWeights& weights) {
  return carry(kPoint.homogeneous(), weights, kDisplacements).head<3>().cast<double>();
}

TEST(Skin, OneBodyCarriesRigidly) {
  EXPECT_LT((carried(rigidWith(1)) - kMotions[1] * kPoint.cast<double>()).norm(), 1e-7);
}

TEST(Skin, WithoutWeightAPointStays) { EXPECT_EQ(carried({}), kPoint.cast<double>()); }

TEST(Skin, HalfAndHalfIsTheMiddle) {
  const Eigen::Vector3d middle =
      0.5 * (kMotions[0] * kPoint.cast<double>() + kMotions[1] * kPoint.cast<double>());
  EXPECT_LT((carried(mix(rigidWith(0), rigidWith(1), 0.5)) - middle).norm(), 1e-7);
}

TEST(Skin, MixingWithItselfChangesNothing) {
  const BodyWeights one = mix(rigidWith(0), rigidWith(1), 0.3);
  EXPECT_LT((carried(mix(one, one, 0.7)) - carried(one)).norm(), 1e-7);
}

TEST(Skin, AtRestEveryBitIsKept) {
  const std::array<BodyDisplacement, 2> rest{displacementOf(Eigen::Isometry3d::Identity()),
                                             displacementOf(turn(1e-15, {1e-16, 0.0, 0.0}))};
  const std::vector<Eigen::Vector3f> points{kPoint, -3.0f * kPoint};
  const std::vector<BodyWeights> weights(2, mix(rigidWith(0), rigidWith(1), 0.5));
  std::vector<Eigen::Vector3f> now(2);
  carryAll(points, weights, rest, now);
  EXPECT_EQ(now, points);
}

TEST(Skin, RefusesMoreThanItHolds) {
  BodyWeights weights;
  for (int body = 0; body < BodyWeights::kMax; ++body) weights.add(body, 0.2);
  weights.add(2, 0.1);  // known already
  EXPECT_THROW(weights.add(9, 0.1), std::invalid_argument);
  EXPECT_THROW(weights.add(-1, 0.1), std::invalid_argument);
  std::vector<Eigen::Vector3f> now(1);
  EXPECT_THROW(carryAll(now, {}, kDisplacements, now), std::invalid_argument);
}

}  // namespace
}  // namespace pleura
