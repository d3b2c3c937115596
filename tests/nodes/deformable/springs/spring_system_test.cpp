#include <random>

#include "elastic_surface.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/springs/spring_energy.h>
#include <pleura/nodes/deformable/springs/spring_system.h>
#include <pleura/tests/nodes/deformable/mesh/shapes.h>

namespace pleura {
namespace {

// The matrix of the system as a whole, from its definition.
Eigen::MatrixXd dense(const ElasticSurface& surface, double slope) {
  const SpringWorkspace& w = surface.workspace;
  const int points = surface.model.pointCount();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * points, 3 * points);
  for (int a = 0; a < points; ++a) {
    matrix.block<3, 3>(3 * a, 3 * a).diagonal().array() += w.diagonal[a];
    for (int s = surface.model.begin[a]; s < surface.model.begin[a + 1]; ++s) {
      const int b = surface.model.end[s];
      const SpringTangent& t = w.tangent[s];
      const Eigen::Matrix3d block = t.lateral * Eigen::Matrix3d::Identity() + t.axial * t.n * t.n.transpose();
      matrix.block<3, 3>(3 * a, 3 * a) += block;
      matrix.block<3, 3>(3 * b, 3 * b) += block;
      matrix.block<3, 3>(3 * a, 3 * b) -= block;
      matrix.block<3, 3>(3 * b, 3 * a) -= block;
    }
  }
  Eigen::VectorXd c(3 * points);
  for (int i = 0; i < points; ++i) c.segment<3>(3 * i) = w.volumeGradient[i];
  matrix += slope * c * c.transpose();
  for (int i = 0; i < points; ++i)
    if (w.isDriven[i] != 0) {
      matrix.middleRows<3>(3 * i).setZero();
      matrix.middleCols<3>(3 * i).setZero();
    }
  return matrix;
}

class SpringSystem : public testing::Test {
 protected:
  SpringSystem() : surface_(geodesicSphere(3, 1), {{50}, {0.01}, 0}, GasInterior{100, 40}) {
    std::mt19937 random(1);
    for (const int i : {3, 40, 41}) surface_.workspace.isDriven[i] = 1;
    prepareForStep(surface_.model, surface_.workspace, surface_.model.rest,
                   Points(surface_.model.rest.size(), Eigen::Vector3d(1, 0, 0)), 0.1);
    surface_.workspace.trial = surface_.model.rest;
    for (Eigen::Vector3d& p : surface_.workspace.trial) p += 0.1 * shapes::randomPoint(random).cast<double>();
    evaluateSprings(surface_.model, surface_.workspace);
  }

  double error(double slope) const {
    const Eigen::MatrixXd matrix = dense(surface_, slope);
    const int points = surface_.model.pointCount();
    Eigen::VectorXd x(3 * points), g(3 * points);
    for (int i = 0; i < points; ++i) {
      x.segment<3>(3 * i) = surface_.workspace.direction[i];
      g.segment<3>(3 * i) = surface_.workspace.gradient[i];
    }
    return (matrix * x + g).norm() / g.norm();
  }

  ElasticSurface surface_;
};

TEST_F(SpringSystem, IsSolvedWhateverTheSlope) {
  for (const double slope : {0.0, 10.0, 1e6, 1e12}) {
    const int iterations = solveSpringSystem(surface_.model, surface_.workspace, slope, 1e-3, 1e-12, 1000);
    EXPECT_LT(iterations, 150);
    // one part in 1e-12 of the sum, of which the stiffest term makes all but a slope's share
    EXPECT_LT(error(slope), 1e-9 * std::max(1.0, slope / 1e5)) << slope;
    for (const int i : {3, 40, 41}) EXPECT_TRUE(surface_.workspace.direction[i].isZero(0));
  }
}

TEST_F(SpringSystem, AStiffInteriorCostsNoMoreIterations) {
  const int soft = solveSpringSystem(surface_.model, surface_.workspace, 0, 0, 1e-6, 1000);
  const int stiff = solveSpringSystem(surface_.model, surface_.workspace, 1e9, 0, 1e-6, 1000);
  EXPECT_LE(stiff, soft + 5);
}

TEST_F(SpringSystem, EveryNumberOfIterationsLeavesADescent) {
  for (int iterations = 1; iterations < 20; ++iterations) {
    solveSpringSystem(surface_.model, surface_.workspace, 100, 0, 1e-12, iterations);
    double slope = 0;
    for (std::size_t i = 0; i < surface_.workspace.gradient.size(); ++i)
      slope += surface_.workspace.gradient[i].dot(surface_.workspace.direction[i]);
    EXPECT_LT(slope, 0);
  }
}

// Nothing resists out of the plane of a flat surface that is not stretched.
TEST(FlatSpringSystem, IsSolvedInItsPlaneAndLeftAloneOutOfIt) {
  const TriangleMesh square{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  ElasticSurface surface(square, {{50}, {0.01}, 0});
  SpringWorkspace& w = surface.workspace;
  prepareForRest(surface.model, w);
  w.trial = surface.model.rest;
  for (Eigen::Vector3d& p : w.trial) p *= 0.9;
  evaluateSprings(surface.model, w);
  EXPECT_GT(solveSpringSystem(surface.model, w, 0, 0, 1e-9, 100), 0);
  for (std::size_t i = 0; i < w.direction.size(); ++i) {
    const Eigen::Vector3d toRest = surface.model.rest[i] - w.trial[i];
    const Eigen::Vector3d along = w.direction[i] - w.direction[0];
    EXPECT_LT((along - toRest).norm(), 1e-6) << "the springs are as long as at rest again";
  }
  std::fill(w.gradient.begin(), w.gradient.end(), Eigen::Vector3d::UnitZ());
  solveSpringSystem(surface.model, w, 0, 0, 1e-9, 100);
  for (const Eigen::Vector3d& d : w.direction) EXPECT_TRUE(d.isZero(0));
}

}  // namespace
}  // namespace pleura
