#include <gtest/gtest.h>

#include <pleura/nodes/lung/planar/plane_strain.h>
#include <pleura/nodes/lung/planar/polygon.h>

namespace pleura::planar {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kSlice = 0.08;

VectorXd fieldOf(const LungMesh& mesh, const Eigen::Matrix2d& gradient, const Vector2d& shift) {
  VectorXd u(static_cast<Eigen::Index>(2 * mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    u.segment<2>(static_cast<Eigen::Index>(2 * i)) = gradient * mesh.points[i] + shift;
  return u;
}

double areaOf(const LungMesh& mesh) {
  return area(std::span(mesh.points).first(static_cast<std::size_t>(mesh.outlineCount)));
}

TEST(PlaneStrain, PatchTestIsExact) {
  const LungMesh mesh = makeHemithorax({.rings = 6}).lung;
  Eigen::Matrix2d gradient;
  gradient << 0.1, -0.03, 0.07, 0.05;
  const Eigen::Vector3d strain(0.1, 0.05, 0.04);
  for (const double nu : {0.0, 0.3, 0.49, 0.4999}) {
    const LungTissue tissue{.poissonsRatio = nu};
    const auto k = stiffnessMatrix(mesh, tissue, kSlice);
    const VectorXd u = fieldOf(mesh, gradient, Vector2d(0.02, -0.01));
    const VectorXd force = k * u;
    const double scale = force.lpNorm<Eigen::Infinity>();
    EXPECT_NEAR(force.tail(force.size() - 2 * mesh.outlineCount).lpNorm<Eigen::Infinity>(), 0, 1e-11 * scale);
    const double energy =
        areaOf(mesh) * kSlice * strain.dot(planeStrain(tissue.youngsModulus, nu) * strain) / 2;
    EXPECT_NEAR(u.dot(force) / 2, energy, 1e-11 * energy);
  }
}

TEST(PlaneStrain, RigidMotionHasNoForceAndTheMassIsAll) {
  const LungMesh mesh = makeHemithorax({}).lung;
  Eigen::Matrix2d turn;
  turn << 0, -1, 1, 0;
  const auto k = stiffnessMatrix(mesh, {}, kSlice);
  const auto m = massMatrix(mesh, {}, kSlice);
  EXPECT_NEAR((k * fieldOf(mesh, turn, Vector2d(3, 4))).lpNorm<Eigen::Infinity>(), 0, 1e-11);
  EXPECT_NEAR(Eigen::MatrixXd(k - Eigen::SparseMatrix<double>(k.transpose())).norm(), 0, 1e-12);
  const VectorXd right = fieldOf(mesh, Eigen::Matrix2d::Zero(), Vector2d(1, 0));
  EXPECT_NEAR(right.dot(m * right), LungTissue{}.density * kSlice * areaOf(mesh), 1e-14);
}

}  // namespace
}  // namespace pleura::planar
