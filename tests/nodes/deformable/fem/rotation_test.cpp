#include <random>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/rotation.h>

namespace pleura {
namespace {

void expectBest(const Eigen::Matrix3d& F) {
  const Eigen::Matrix3d R = nearestRotation(F);
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-12) << F;
  EXPECT_NEAR(R.determinant(), 1, 1e-12) << F;
  // Greatest where R^T F is symmetric and the sum of any two of its eigenvalues is not negative; here: than
  // whatever is near it and far from it.
  const Eigen::Matrix3d S = R.transpose() * F;
  EXPECT_LE((S - S.transpose()).norm(), 1e-10 * F.norm()) << F;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100; ++i) {
    const Eigen::Quaterniond q =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
    EXPECT_LE((q.toRotationMatrix().transpose() * F).trace(), S.trace() + 1e-12 * F.norm()) << F;
  }
}

TEST(NearestRotation, OfAnyMatrix) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) expectBest(Eigen::Matrix3d::NullaryExpr([&] { return normal(random); }));
}

TEST(NearestRotation, OfFlatMirroredAndVanishingOnes) {
  const Eigen::Matrix3d Q(Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, -1).normalized()));
  for (const Eigen::Vector3d& s : std::initializer_list<Eigen::Vector3d>{{1, 1, 0},
                                                                         {1, 0.5, 1e-9},
                                                                         {1, 0, 0},
                                                                         {0, 0, 0},
                                                                         {1, 1, -1},
                                                                         {-1, -1, -1},
                                                                         {3, 2, -1},
                                                                         {1e-30, 1e-30, 1e-30},
                                                                         {1e-50, 0, 0},
                                                                         {1e12, 1, 1e-12},
                                                                         {1e9, 1e9, -1e9},
                                                                         {10, 10, 10}}) {
    expectBest(s.asDiagonal());
    expectBest(Q * s.asDiagonal());
    expectBest(Q * s.asDiagonal() * Q);
  }
}

TEST(NearestRotation, IsTheTurnOfATurnedStretch) {
  const Eigen::Matrix3d Q(Eigen::AngleAxisd(3.1, Eigen::Vector3d(1, 2, 3).normalized()));
  const Eigen::Matrix3d S = Q * Eigen::Vector3d(0.3, 1.5, 2).asDiagonal() * Q.transpose();
  EXPECT_LT((nearestRotation(Q * S) - Q).norm(), 1e-14);
  EXPECT_LT((nearestRotation(Q) - Q).norm(), 1e-15);
}

}  // namespace
}  // namespace pleura
