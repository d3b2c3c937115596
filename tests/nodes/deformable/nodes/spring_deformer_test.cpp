#include <functional>

#include "pressure_at_rest.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/topology.h>
#include <pleura/nodes/deformable/spring_deformer.h>
#include <pleura/tests/nodes/deformable/springs/geodesic_sphere.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

class SpringDeformerTest : public ::testing::Test {
 protected:
  std::shared_ptr<SpringDeformer> springs(const char* interior) {
    auto deformer = context.make<SpringDeformer>([&](SpringDeformer& d) { d.interior.setValue(interior); });
    deformer->setRest(ball, {});
    return deformer;
  }

  double volumeOf(SpringDeformer& deformer) {
    std::vector<Vec3f> shape(ball.points.size());
    deformer.deform({}, {}, shape);
    return signedVolume(shape, ball.triangles);
  }

  /// V = s^3 V_0 where p 3 V_0 s^2 = k (s - 1) sum(l_0^2), p [Pa] a function of s, sum over the edges.
  double stretchedVolume(const std::function<double(double)>& p, double k) {
    double squares = 0;
    for (const auto& edge : edges(ball.points.size(), ball.triangles))
      squares +=
          (ball.points[static_cast<std::size_t>(edge[1])] - ball.points[static_cast<std::size_t>(edge[0])])
              .cast<double>()
              .squaredNorm();
    double low = 1, high = 2;
    for (int i = 0; i < 60; ++i) {
      const double s = (low + high) / 2;
      (p(s) * 3 * restVolume * s * s > k * (s - 1) * squares ? low : high) = s;
    }
    return low * low * low * restVolume;
  }

  TestContext context;
  TriangleMesh ball = geodesicSphere(16, 0.05f);
  double restVolume = signedVolume(ball.points, ball.triangles);
};

TEST_F(SpringDeformerTest, ABallUnderPressureSwellsAsItsEnergySays) {
  const auto deformer = springs("PRESSURE");
  for (const float pressure : {50.f, 200.f}) {
    deformer->pressure.setValue(pressure);
    const double expected = stretchedVolume([&](double) { return pressure; }, deformer->stiffness.getValue());
    EXPECT_NEAR(volumeOf(*deformer) - restVolume, expected - restVolume, 0.02 * (expected - restVolume));
    EXPECT_FLOAT_EQ(deformer->interiorPressure.getValue(), pressure);
  }
}

TEST_F(SpringDeformerTest, OnlyPressureAboveThatAtRestCounts) {
  expectOnlyPressureAboveThatAtRestCounts(*springs("PRESSURE"), restVolume,
                                          [this](auto& deformer) { return volumeOf(deformer); });
}

TEST_F(SpringDeformerTest, AGasIsInBalanceWithWhatIsOutsideAtRest) {
  const auto deformer = springs("GAS");
  deformer->ambientPressure.setValue(1000);
  EXPECT_NEAR(volumeOf(*deformer), restVolume, 1e-6 * restVolume);
  deformer->pressure.setValue(100);
  const auto pressure = [](double s) { return 1100 / (s * s * s) - 1000; };
  const double expected = stretchedVolume(pressure, deformer->stiffness.getValue());
  EXPECT_NEAR(volumeOf(*deformer) - restVolume, expected - restVolume, 0.02 * (expected - restVolume));
}

TEST_F(SpringDeformerTest, AnUnknownInteriorIsRefusedByName) {
  const auto deformer = context.make<SpringDeformer>([](SpringDeformer& d) { d.interior.setValue("AIR"); });
  try {
    deformer->setRest(ball, {});
    FAIL() << "taken";
  } catch (const std::invalid_argument& refused) {
    EXPECT_STREQ(refused.what(), "interior is EMPTY, GAS, PRESSURE or VOLUME, not AIR");
  }
}

}  // namespace
}  // namespace pleura
