#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/nodes/thorax/motion/rigid_fit.h>

namespace pleura {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Eigen::Vector3d randomVector(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  return {uniform(random), uniform(random), uniform(random)};
}

Eigen::Isometry3d randomMotion(std::mt19937& random, double angle, double shift) {
  const Eigen::Vector3d turn = randomVector(random, angle);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  motion.translation() = randomVector(random, shift);
  return motion;
}

double squaredError(const Eigen::Isometry3d& motion, const Points& from, const Points& to) {
  double sum = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) sum += (motion * from[i] - to[i]).squaredNorm();
  return sum;
}

TEST(RigidFit, RecoversARigidMotion) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Isometry3d truth = randomMotion(random, 2.0, 1.0);
    Points from, to;
    for (int i = 0; i < 14; ++i) {
      from.push_back(randomVector(random, 0.2));
      to.push_back(truth * from.back());
    }
    EXPECT_LT((fitRigid(from, to).matrix() - truth.matrix()).norm(), 1e-12);
  }
}

TEST(RigidFit, NoNearbyMotionFitsBetter) {
  std::mt19937 random(11);
  Points from, to;
  for (int i = 0; i < 14; ++i) {
    from.push_back(randomVector(random, 0.2));
    to.push_back(from.back() + randomVector(random, 0.02));
  }
  const Eigen::Isometry3d best = fitRigid(from, to);
  for (int trial = 0; trial < 200; ++trial) {
    EXPECT_GT(squaredError(randomMotion(random, 1e-3, 1e-4) * best, from, to), squaredError(best, from, to));
  }
}

TEST(RigidFit, NeverReflects) {
  std::mt19937 random(3);
  Points from, to;
  for (int i = 0; i < 14; ++i) {
    from.push_back(randomVector(random, 0.2));
    to.push_back({-from.back().x(), from.back().y(), from.back().z()});
  }
  EXPECT_NEAR(fitRigid(from, to).linear().determinant(), 1.0, 1e-12);
}

TEST(RigidFit, RefusesWhatHasNoFit) {
  const Points one{{0.0, 0.0, 0.0}};
  EXPECT_THROW(fitRigid({}, {}), std::invalid_argument);
  EXPECT_THROW(fitRigid(one, Points(2, one[0])), std::invalid_argument);
  EXPECT_THROW(fitRigid(one, Points{{0.0, std::numeric_limits<double>::infinity(), 0.0}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace pleura
