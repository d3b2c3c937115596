#include <random>

#include <gtest/gtest.h>

#include <pleura/nodes/lung/planar/condensed_lung.h>
#include <pleura/nodes/lung/planar/pleural_space.h>
#include <pleura/nodes/lung/planar/polygon.h>

namespace pleura::planar {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// A lung blown up evenly about its hilum until its edge is in contact here and there.
struct Example {
  explicit Example(bool isMirrored)
      : half(makeHemithorax({.naturalScale = 0.985, .isMirrored = isMirrored})),
        tissue(half.lung, {}, 0.08),
        space(half.wall, std::span(half.lung.points).first(static_cast<std::size_t>(half.lung.outlineCount)),
              tissue.firstFree, tissue.size() / 2, 0.08, 0.003, 0.985, 300),
        u(VectorXd::Zero(tissue.size())) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> some(-3e-4, 3e-4);
    for (Index i = 0; i < u.size(); ++i) u[i] = some(random);
  }

  double energyAt(const VectorXd& z, const PleuralGas& gas) {
    EXPECT_TRUE(space.place(z.head(u.size()), z.tail<2>()));
    return space.energy(gas);
  }
  VectorXd forceAt(const VectorXd& z, const PleuralGas& gas) {
    EXPECT_TRUE(space.place(z.head(u.size()), z.tail<2>()));
    VectorXd onLung = VectorXd::Zero(u.size());
    Vector2d onChest = Vector2d::Zero();
    space.addForces(gas, onLung, onChest);
    VectorXd all(z.size());
    all << onLung, onChest;
    return all;
  }

  Hemithorax half;
  CondensedLung tissue;
  PleuralSpace space;
  VectorXd u;
};

TEST(PleuralSpace, ForceIsMinusTheGradientAndStiffnessItsDerivative) {
  for (const bool isMirrored : {false, true}) {
    Example example(isMirrored);
    VectorXd z(example.u.size() + 2);
    z << example.u, 0.0005, 0.0007;
    ASSERT_TRUE(example.space.place(example.u, z.tail<2>()));
    const double volume = example.space.volume();
    for (const PleuralGas& gas :
         {PleuralGas{false, -490, 0, 101325}, PleuralGas{true, 0, 1e5 * volume, 101325},
          PleuralGas{false, 0, 0, 101325}}) {
      const VectorXd force = example.forceAt(z, gas);
      MatrixXd lung = MatrixXd::Zero(example.u.size(), example.u.size());
      Eigen::MatrixX2d lungChest = Eigen::MatrixX2d::Zero(example.u.size(), 2);
      Matrix2d chest = Matrix2d::Zero();
      example.space.addStiffness(gas, lung, lungChest, chest);
      MatrixXd stiffness(z.size(), z.size());
      stiffness << lung, lungChest, lungChest.transpose(), chest;
      EXPECT_NEAR((stiffness - stiffness.transpose()).norm(), 0, 1e-11 * stiffness.norm());
      for (Index i = 0; i < z.size(); ++i) {
        const double step = 1e-7;
        const VectorXd more = z + step * VectorXd::Unit(z.size(), i);
        const VectorXd less = z - step * VectorXd::Unit(z.size(), i);
        EXPECT_NEAR(-(example.energyAt(more, gas) - example.energyAt(less, gas)) / (2 * step), force[i],
                    1e-5 * force.lpNorm<Eigen::Infinity>() + 2e-7);
        const VectorXd column = -(example.forceAt(more, gas) - example.forceAt(less, gas)) / (2 * step);
        EXPECT_NEAR((column - stiffness.col(i)).norm(), 0, 2e-5 * stiffness.norm()) << i;
      }
    }
  }
}

TEST(PleuralSpace, TheExampleTouchesTheWall) {
  Example example(false);
  ASSERT_TRUE(example.space.place(example.u, Vector2d::Zero()));
  VectorXd force = VectorXd::Zero(example.u.size());
  Vector2d onChest = Vector2d::Zero();
  example.space.addForces({}, force, onChest);  // no pressure: contact alone
  EXPECT_GT((force.array() != 0).count(), force.size() / 2);
}

TEST(PleuralSpace, VolumeIsThatBetweenTheOutlines) {
  Example example(false);
  const Vector2d q(0.004, 0.003);
  ASSERT_TRUE(example.space.place(example.u, q));
  std::vector<Vector2d> wall;
  for (std::size_t k = 0; k < example.half.wall.rest.size(); ++k) wall.push_back(example.half.wall.at(k, q));
  EXPECT_NEAR(example.space.volume(), 0.08 * (area(wall) - example.space.lungArea()), 1e-16);
}

TEST(PleuralSpace, LungThroughTheWallIsRefused) {
  Example example(false);
  VectorXd u = example.u;
  u[u.size() / 2] += 0.05;
  EXPECT_FALSE(example.space.place(u, Vector2d::Zero()));
  EXPECT_FALSE(example.space.place(10 * VectorXd::Ones(u.size()), Vector2d::Zero()));
  EXPECT_FALSE(example.space.place(example.u, Vector2d(-0.2, 0))) << "the diaphragm through the lung";
  EXPECT_TRUE(example.space.place(example.u, Vector2d::Zero()));
}

TEST(PleuralGas, KeepsPressureTimesVolume) {
  const PleuralGas gas{true, 0, 100000 * 5e-5, 101325};
  EXPECT_DOUBLE_EQ(gas.gaugeAt(5e-5), -1325);
  for (const double volume : {1e-6, 5e-5, 1e-3})
    EXPECT_NEAR((gas.gaugeAt(volume) + 101325) * volume, 5, 1e-12);
  EXPECT_LT(gas.gaugeAt(6e-5), gas.gaugeAt(5e-5)) << "wider is lower, as gauge pressure would not give";
}

}  // namespace
}  // namespace pleura::planar
