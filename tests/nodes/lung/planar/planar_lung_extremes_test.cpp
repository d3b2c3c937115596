#include <limits>

#include "breath.h"
#include <gtest/gtest.h>

namespace pleura::planar {
namespace {

using Eigen::Vector2d;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(PlanarLungExtremes, StepsFromAMicrosecondToAThousandSeconds) {
  PlanarLungSystem settled = drawnOut();
  ASSERT_TRUE(settled.settle(kQuiet).isConverged);
  for (const double step : {1e-6, 1e-4, 1e-2, 1.0, 1e3}) {
    PlanarLungSystem system = drawnOut();
    for (int k = 0; k < 50; ++k) ASSERT_TRUE(system.step(step, kQuiet).isConverged) << step << " " << k;
    if (step >= 1) {
      EXPECT_NEAR((system.chest() - settled.chest()).norm(), 0, 1e-7) << step;
    }
    for (int k = 0; k < 50; ++k) ASSERT_TRUE(system.step(step, kNone).isConverged) << step << " " << k;
    if (step >= 1) {
      EXPECT_NEAR((system.chest() - drawnOut().chest()).norm(), 0, 1e-6) << step;
    }
  }
}

TEST(PlanarLungExtremes, WhatIsNotFiniteIsRefusedAndTheStateKept) {
  PlanarLungSystem system = drawnOut();
  ASSERT_TRUE(system.step(0.05, kQuiet).isConverged);
  const auto before = stateOf(system);
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    EXPECT_FALSE(system.step(0.05, Vector2d(bad, 0)).isConverged);
    EXPECT_FALSE(system.step(0.05, Vector2d(0, bad)).isConverged);
    EXPECT_FALSE(system.settle(Vector2d(0, bad)).isConverged);
    EXPECT_FALSE(system.step(bad, kNone).isConverged);
    EXPECT_FALSE(system.setPressure(0, bad));
  }
  for (const double step : {0.0, -1.0, 1e-200}) EXPECT_FALSE(system.step(step, kNone).isConverged) << step;
  EXPECT_FALSE(system.setPressure(0, -2e5)) << "below a vacuum";
  EXPECT_EQ(stateOf(system), before);
  EXPECT_TRUE(system.step(0.05, kQuiet).isConverged);
}

TEST(PlanarLungExtremes, AForceBeyondAllMeasureIsBorneOrReported) {
  for (const double size : {1e2, 1e3, 1e4, 1e6})
    for (const Vector2d& sense : {Vector2d(1, 1), Vector2d(-1, -1), Vector2d(1, -1), Vector2d(-1, 1)}) {
      PlanarLungSystem system = drawnOut();
      for (int k = 0; k < 20; ++k) {
        const auto before = stateOf(system);
        const PlanarLungStatus status = system.step(0.05, size * sense);
        EXPECT_TRUE(status.isConverged || stateOf(system) == before);
        for (const double x : stateOf(system)) ASSERT_TRUE(std::isfinite(x));
        EXPECT_GT(system.pleuralVolume(0), 0);
      }
    }
}

TEST(PlanarLungExtremes, ABlowFromThatItRecovers) {
  PlanarLungSystem system = drawnOut();
  const Vector2d chest = system.chest();
  for (const double size : {30.0, -50.0}) {
    for (int k = 0; k < 20; ++k) system.step(0.02, Vector2d(size, size));
    for (int k = 0; k < 200; ++k) ASSERT_TRUE(system.step(0.05, kNone).isConverged) << size << " " << k;
    EXPECT_NEAR((system.chest() - chest).norm(), 0, 1e-4) << size;
  }
}

TEST(PlanarLungExtremes, NearlyIncompressibleStiffAndSoftTissue) {
  for (const LungTissue& tissue :
       {LungTissue{.poissonsRatio = 0.49}, LungTissue{.poissonsRatio = 0.499},
        LungTissue{.youngsModulus = 1.6e10}, LungTissue{.youngsModulus = 300}, LungTissue{.density = 1e-3},
        LungTissue{.relaxationTime = 0}, LungTissue{.relaxationTime = 100}}) {
    PlanarLungParameters parameters;
    parameters.lungs[0].tissue = tissue;
    PlanarLungSystem system(parameters);
    EXPECT_TRUE(system.drawOut().isConverged) << tissue.youngsModulus << " " << tissue.poissonsRatio;
    for (int k = 1; k <= 80; ++k)
      EXPECT_TRUE(system.step(0.05, effort(0.05 * k) * kQuiet).isConverged)
          << k << ": " << tissue.youngsModulus << " " << tissue.poissonsRatio << " " << tissue.relaxationTime;
  }
}

// So stiff against a change of area that linear triangles lock: the lung may fail to come out, and says so.
TEST(PlanarLungExtremes, WhatDoesNotConvergeKeepsItsState) {
  PlanarLungParameters parameters;
  parameters.lungs[0].tissue.poissonsRatio = 0.4999;
  PlanarLungSystem system(parameters);
  const auto before = stateOf(system);
  const PlanarLungStatus status = system.drawOut();
  EXPECT_TRUE(status.isConverged || stateOf(system) == before);
  EXPECT_EQ(system.isSealed(0), status.isConverged);
  EXPECT_TRUE(system.step(0.05, kNone).isConverged);
}

TEST(PlanarLungExtremes, PressuresFarAboveAndBelow) {
  for (const double gauge : {-50000.0, -5000.0, -2000.0, 500.0, 1500.0}) {
    PlanarLungSystem system = drawnOut();
    ASSERT_TRUE(system.setPressure(0, gauge));
    for (int k = 0; k < 100; ++k) {
      system.step(0.02, kNone);
      for (const double x : stateOf(system)) ASSERT_TRUE(std::isfinite(x));
    }
    ASSERT_TRUE(system.setPressure(0, 0));
    for (int k = 0; k < 300; ++k) ASSERT_TRUE(system.step(0.05, kNone).isConverged) << gauge << " " << k;
    EXPECT_LT(system.chest().norm(), 1e-6) << "recovers from " << gauge;
  }
}

TEST(PlanarLungExtremes, ChestWithoutALung) {
  PlanarLungParameters parameters;
  parameters.lungs.clear();
  PlanarLungSystem system(parameters);
  EXPECT_TRUE(system.drawOut().isConverged);
  EXPECT_TRUE(system.settle(kQuiet).isConverged);
  EXPECT_NEAR(system.chest()[0], kQuiet[0] / parameters.diaphragm.stiffness, 1e-12);
}

TEST(PlanarLungExtremes, ParametersOutsideTheirRangeAreRefused) {
  for (const double bad : {0.0, -1.0, kNaN, kInfinity}) {
    for (double PlanarLungParameters::*field :
         {&PlanarLungParameters::thickness, &PlanarLungParameters::ambientPressure,
          &PlanarLungParameters::contactPressure}) {
      PlanarLungParameters parameters;
      parameters.*field = bad;
      EXPECT_THROW(PlanarLungSystem{parameters}, std::invalid_argument);
    }
    PlanarLungParameters parameters;
    parameters.chestWall.mass = bad;
    EXPECT_THROW(PlanarLungSystem{parameters}, std::invalid_argument);
  }
  for (const double bad : {kNaN, -2e5}) {
    PlanarLungParameters parameters;
    parameters.intrapleuralPressure = bad;
    EXPECT_THROW(PlanarLungSystem{parameters}, std::invalid_argument);
  }
}

}  // namespace
}  // namespace pleura::planar
