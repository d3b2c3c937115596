#include <cmath>

#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/lung/shape/freed_lung.h>
#include <pleura/tests/nodes/deformable/chainmail/icosphere.h>

namespace pleura {
namespace {

using Points = std::vector<Eigen::Vector3f>;

/// A ball of 5 cm, held around x = -5 cm.
class FreedLungTest : public ::testing::Test {
 protected:
  FreedLungTest() : ball(icosphere(3, 0.05f)) {
    for (std::size_t i = 0; i < ball.points.size(); ++i)
      if (ball.points[i].x() < -0.045f) hilum.push_back(static_cast<int>(i));
    volume = signedVolume(ball.points, ball.triangles);
  }

  /// The ball's points stretched by `factor`, the hilum left where it is.
  Points cavityOf(const Eigen::Vector3f& factor) const {
    const Eigen::Vector3f middle(-0.0475f, 0, 0);
    Points cavity = ball.points;
    for (Eigen::Vector3f& p : cavity) p = middle + factor.cwiseProduct(p - middle);
    return cavity;
  }

  Points shapeOf(FreedLung& lung, double wanted, const Points& cavity) {
    Points points = ball.points;
    report = lung.shape(wanted, cavity, points);
    return points;
  }

  TriangleMesh ball;
  std::vector<int> hilum;
  double volume = 0;
  FreedLungReport report;
};

TEST_F(FreedLungTest, HasTheComplianceAndTheVolumeThatWereAsked) {
  constexpr double kCompliance = 1e-7;  // [m^3/Pa]
  FreedLung lung(ball, hilum, {.compliance = kCompliance});
  const Points free = cavityOf({3, 3, 3});
  for (const double share : {0.97, 0.99, 1.01}) {
    const Points points = shapeOf(lung, share * volume, free);
    EXPECT_TRUE(report.hasConverged);
    EXPECT_NEAR(signedVolume(points, ball.triangles), share * volume, 1e-5 * volume);
    const double pressure = (share - 1) * volume / kCompliance;
    EXPECT_NEAR(report.pressure, pressure, 0.03 * std::abs(pressure)) << "but for what is not linear";
  }
}

TEST_F(FreedLungTest, StaysInsideItsCavity) {
  FreedLung lung(ball, hilum, {});
  const Points cavity = cavityOf({1.1f, 0.8f, 1.1f});
  const SurfaceQuery wall(cavity, ball.triangles);
  for (const Eigen::Vector3f& point : shapeOf(lung, 0.85 * volume, cavity))
    EXPECT_LT(wall.signedDistance(point.cast<double>()), 1e-7);
  EXPECT_TRUE(report.hasConverged);
  EXPECT_GT(report.touching, 20);
}

TEST_F(FreedLungTest, HasNoMemory) {
  const Points wide = cavityOf({1.1f, 0.8f, 1.1f}), flat = cavityOf({1.2f, 1.1f, 0.7f});
  FreedLung first(ball, hilum, {}), second(ball, hilum, {});
  const Points expected = shapeOf(first, 0.85 * volume, wide);
  const int solves = report.solves;
  shapeOf(second, 0.7 * volume, flat);
  shapeOf(second, 0.9 * volume, cavityOf({2, 2, 2}));
  EXPECT_EQ(shapeOf(second, 0.85 * volume, wide), expected);
  EXPECT_EQ(shapeOf(second, 0.85 * volume, wide), expected);
  EXPECT_GT(solves, 1);
}

TEST_F(FreedLungTest, RefusesWhatHoldsNothing) {
  EXPECT_THROW(FreedLung(ball, {}, {}), std::invalid_argument);
  EXPECT_THROW(FreedLung(ball, std::vector<int>{-1}, {}), std::invalid_argument);
  EXPECT_THROW(FreedLung(ball, hilum, {.compliance = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace pleura
