#include <numbers>
#include <numeric>

#include "elastic_surface.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/springs/spring_start.h>

namespace pleura {
namespace {

struct Motion {
  Points rest = ElasticSurface(geodesicSphere(3, 1)).model.rest;
  std::vector<int> driven;
  Points targets;

  Eigen::Isometry3d carried(const Eigen::Isometry3d& by) {
    targets.clear();
    for (const int i : driven) targets.push_back(by * rest[i]);
    return carryRigidly(rest, driven, targets);
  }
};

TEST(SpringStart, FindsTheMotionThatWasMade) {
  Motion motion;
  motion.driven = {0, 7, 30, 31};
  for (const double angle : {0.0, 1e-6, 0.5, 1.5, 3.0})
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, -2, 0.5)}) {
      const Eigen::Isometry3d made =
          Eigen::Translation3d(3, 2, 1) * Eigen::AngleAxisd(angle, axis.normalized());
      EXPECT_TRUE(motion.carried(made).isApprox(made, 1e-9)) << angle;
    }
}

TEST(SpringStart, MakesNoTurnThatThePointsLeaveOpen) {
  Motion motion;
  EXPECT_TRUE(carryRigidly(motion.rest, {}, {}).isApprox(Eigen::Isometry3d::Identity(), 0));
  const Eigen::Isometry3d made =
      Eigen::Translation3d(3, 2, 1) * Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX());
  motion.driven = {5};
  EXPECT_TRUE(motion.carried(made).linear().isIdentity(0));
  motion.driven = {5, 20};
  const Eigen::AngleAxisd least(motion.carried(made).linear());
  EXPECT_LT(least.angle(), 1.0);
  const Eigen::Vector3d along = motion.rest[20] - motion.rest[5];
  EXPECT_TRUE((least * along).isApprox(made.linear() * along, 1e-9));
  EXPECT_NEAR(least.axis().dot(along.normalized()), 0, 1e-6) << "turned about the line as well";
}

}  // namespace
}  // namespace pleura
