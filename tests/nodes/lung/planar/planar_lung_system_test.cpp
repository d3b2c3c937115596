#include "breath.h"
#include <gtest/gtest.h>

namespace pleura::planar {
namespace {

using Eigen::Vector2d;

constexpr double kStep = 0.05;       // [s]
constexpr double kCmH2O = 98.0665;   // [Pa]
constexpr double kAmbient = 101325;  // [Pa]

/// Breathes from time to time, checks every step, and calls back after each.
template <class After>
void breathe(PlanarLungSystem& system, double seconds, double step, const After& after, double from = 0) {
  const int count = static_cast<int>(std::lround(seconds / step));
  for (int k = 1; k <= count; ++k) {
    const PlanarLungStatus status = system.step(step, effort(from + k * step) * kQuiet);
    ASSERT_TRUE(status.isConverged) << k << ": " << status.iterations << " iterations, " << status.residual;
    after(from + k * step);
  }
}
void breathe(PlanarLungSystem& system, double seconds, double step = kStep) {
  breathe(system, seconds, step, [](double) {});
}
void rest(PlanarLungSystem& system, double seconds, double step = kStep) {
  for (int k = 0; k < std::lround(seconds / step); ++k) ASSERT_TRUE(system.step(step, kNone).isConverged);
}

/// Largest distance [m] of a lung's points from their natural places.
double stretchOf(const PlanarLungSystem& system, std::size_t lung) {
  const auto& natural = system.hemithorax(lung).lung.points;
  std::vector<Vector2d> points(natural.size());
  system.placeLung(lung, points);
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    largest = std::max(largest, (points[i] - natural[i]).norm());
  return largest;
}

TEST(PlanarLungSystem, TheNaturalShapeIsAtRest) {
  PlanarLungSystem system{PlanarLungParameters{}};
  EXPECT_EQ(system.pressure(0), 0);
  rest(system, 1);
  EXPECT_LT(stretchOf(system, 0), 1e-9);
}

TEST(PlanarLungSystem, DrawnOutTheLungFillsTheCavity) {
  const PlanarLungSystem natural{PlanarLungParameters{}};
  const PlanarLungSystem system = drawnOut();
  EXPECT_TRUE(system.isSealed(0));
  EXPECT_NEAR(system.pressure(0), -5 * kCmH2O, 1e-6);
  EXPECT_GT(system.lungArea(0), 1.3 * natural.lungArea(0));
  const double cavity = system.lungArea(0) + stripArea(system, 0);
  EXPECT_GT(system.lungArea(0), 0.94 * cavity);
  const Vector2d gap = system.meanAndLargestGap(0);
  EXPECT_LT(gap[0], 0.0015) << "the film is 1 mm";
  EXPECT_LT(gap[1], 0.0065) << "in the recess, which no lung fills at rest";
  EXPECT_LT(system.chest().maxCoeff(), -0.003) << "the recoil draws the chest in";
}

TEST(PlanarLungSystem, AQuietBreathHasTheMeasuredPressuresAndVolumes) {
  PlanarLungSystem system = drawnOut();
  const double area = system.lungArea(0);
  const double dome = system.chest()[0];
  double least = 0;
  double most = 0;
  double lowest = dome;
  bool isFalling = true;
  double before = system.pressure(0);
  breathe(system, kPeriod, kStep, [&](double time) {
    if (time < kInhale) isFalling = isFalling && system.pressure(0) < before;
    before = system.pressure(0);
    least = std::min(least, system.pressure(0));
    most = std::max(most, system.lungArea(0));
    lowest = std::max(lowest, system.chest()[0]);
  });
  EXPECT_TRUE(isFalling) << "on inhaling";
  EXPECT_NEAR(least, -7.5 * kCmH2O, 0.3 * kCmH2O) << "Guyton: -5 to -7.5 cmH2O";
  const double tidal = (most - area) * PlanarLungParameters{}.thickness;
  EXPECT_NEAR(2 * tidal, 5e-4, 0.5e-4) << "two lungs: 0.5 L";
  const double compliance = 2 * tidal / (-5 * kCmH2O - least) * kCmH2O * 1e3;
  EXPECT_NEAR(compliance, 0.2, 0.02) << "[L/cmH2O], Guyton";
  EXPECT_GT(lowest - dome, 0.008) << "quiet breathing, measured: 0.8 to 2.1 cm";
  EXPECT_LT(lowest - dome, 0.021);
  EXPECT_NEAR(system.lungArea(0), area, 3e-4 * area) << "the exhale brings it back";
}

TEST(PlanarLungSystem, PressureTimesVolumeIsKept) {
  PlanarLungSystem system = drawnOut();
  const auto product = [&] { return (kAmbient + system.pressure(0)) * stripArea(system, 0) * 0.08; };
  const double start = product();
  double worst = 0;
  breathe(system, 2 * kPeriod, kStep,
          [&](double) { worst = std::max(worst, std::abs(product() / start - 1)); });
  EXPECT_LT(worst, 1e-9);
}

TEST(PlanarLungSystem, BreathOneHundredIsBreathTwo) {
  PlanarLungSystem system = drawnOut();
  std::vector<double> second;
  breathe(system, kPeriod);
  breathe(system, kPeriod, kStep, [&](double) { second.push_back(system.lungArea(0)); });
  breathe(system, 97 * kPeriod);
  std::size_t k = 0;
  double worst = 0;
  breathe(system, kPeriod, kStep,
          [&](double) { worst = std::max(worst, std::abs(system.lungArea(0) / second[k++] - 1)); });
  EXPECT_LT(worst, 2e-6);
  EXPECT_GT(worst, 0) << "compared at all";
}

TEST(PlanarLungSystem, PneumothoraxLetsTheLungFallBackAndTheChestGoOut) {
  PlanarLungSystem system = drawnOut();
  const Vector2d chest = system.chest();
  ASSERT_TRUE(system.setPressure(0, 0));
  rest(system, 10);
  EXPECT_EQ(system.pressure(0), 0);
  EXPECT_LT(stretchOf(system, 0), 1e-6);
  EXPECT_GT((system.chest() - chest).minCoeff(), 0.003);
  EXPECT_LT(system.chest().norm(), 1e-6) << "to its own rest";

  const PlanarLungSystem before = drawnOut();
  ASSERT_TRUE(system.setPressure(0, -5 * kCmH2O));
  rest(system, 10);
  system.seal(0);
  EXPECT_NEAR(system.lungArea(0), before.lungArea(0), 1e-5 * before.lungArea(0)) << "set back, it recovers";
  EXPECT_LT((system.chest() - before.chest()).norm(), 1e-5);
}

TEST(PlanarLungSystem, OneLungCollapsesAndTheOtherBreathesOn) {
  PlanarLungSystem system = drawnOut(twoLungs());
  EXPECT_EQ(system.lungArea(0), system.lungArea(1));
  ASSERT_TRUE(system.setPressure(1, 0));
  const auto breathe2 = [&](double seconds, const auto& after) {
    for (int k = 1; k <= std::lround(seconds / kStep); ++k) {
      ASSERT_TRUE(system.step(kStep, 2 * effort(k * kStep) * kQuiet).isConverged);
      after();
    }
  };
  breathe2(3 * kPeriod, [] {});
  EXPECT_LT(stretchOf(system, 1), 1e-3) << "the wall, drawn in by the other lung, just touches it";
  double least = 1;
  double most = 0;
  double collapsed = 0;
  breathe2(kPeriod, [&] {
    least = std::min(least, system.lungArea(0));
    most = std::max(most, system.lungArea(0));
    collapsed = std::max(collapsed, stretchOf(system, 1));
  });
  EXPECT_GT(most, 1.1 * least);
  EXPECT_LT(collapsed, 1e-3);
  EXPECT_LT(system.pressure(0), -4 * kCmH2O);
}

TEST(PlanarLungSystem, TwoLungsAreTwiceOneAndMirrorEachOtherToTheBit) {
  PlanarLungSystem one = drawnOut();
  PlanarLungSystem two = drawnOut(twoLungs());
  const auto mirrored = [&] {
    const auto left = two.wallPoints(0);
    const auto right = two.wallPoints(1);
    for (std::size_t k = 0; k < left.size(); ++k)
      if (left[k] != Vector2d(-right[k].x(), right[k].y())) return false;
    std::vector<Vector2d> a(two.hemithorax(0).lung.points.size());
    std::vector<Vector2d> b(a.size());
    two.placeLung(0, a);
    two.placeLung(1, b);
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != Vector2d(-b[i].x(), b[i].y())) return false;
    return true;
  };
  EXPECT_TRUE(mirrored());
  for (int k = 1; k * kStep < kPeriod; ++k) {
    ASSERT_TRUE(one.step(kStep, effort(k * kStep) * kQuiet).isConverged);
    ASSERT_TRUE(two.step(kStep, 2 * effort(k * kStep) * kQuiet).isConverged);
    EXPECT_TRUE(mirrored()) << k;
    EXPECT_NEAR((one.chest() - two.chest()).norm(), 0, 1e-7);
  }
}

TEST(PlanarLungSystem, WithoutForceEnergyOnlyFalls) {
  for (const double step : {1e-3, 0.01, 0.05, 1.0}) {
    PlanarLungSystem system = drawnOut();
    breathe(system, kInhale, kInhale / 20);
    double energy = system.energy();
    for (int k = 0; k < 200; ++k) {
      ASSERT_TRUE(system.step(step, kNone).isConverged);
      EXPECT_LE(system.energy(), energy + 1e-10 * std::abs(energy)) << step << " s, step " << k;
      energy = system.energy();
    }
    ASSERT_TRUE(system.setPressure(0, 0));
    energy = system.energy();
    for (int k = 0; k < 200; ++k) {
      ASSERT_TRUE(system.step(step, kNone).isConverged);
      EXPECT_LE(system.energy(), energy + 1e-12) << step << " s, collapsing, step " << k;
      energy = system.energy();
    }
  }
}

TEST(PlanarLungSystem, BackwardEulerIsOfFirstOrder) {
  const auto at = [](double step) {
    PlanarLungSystem system = drawnOut();
    breathe(system, 1, step);
    return system.chest()[0];
  };
  const double exact = at(0.000625) + (at(0.000625) - at(0.00125));  // extrapolated
  const double coarse = std::abs(at(0.02) - exact);
  const double fine = std::abs(at(0.01) - exact);
  EXPECT_NEAR(coarse / fine, 2, 0.2);
  EXPECT_LT(std::abs(at(0.05) - exact), 4e-4) << "[m]";
}

TEST(PlanarLungSystem, MeshesConverge) {
  // stretched by the muscles, its pressure held
  const auto areaAt = [](int rings) {
    PlanarLungParameters parameters;
    parameters.lungs[0].shape.rings = rings;
    return drawnOut(parameters).lungArea(0);
  };
  const double fine = areaAt(24);
  const double e6 = std::abs(areaAt(6) / fine - 1);
  const double e12 = std::abs(areaAt(12) / fine - 1);
  EXPECT_LT(e12, e6 / 1.8);
  EXPECT_LT(std::abs(areaAt(5) / fine - 1), 0.03);
}

TEST(PlanarLungSystem, TheSameRunHasTheSameBitsAndACopyGoesOnAsItsOriginal) {
  PlanarLungSystem a = drawnOut(twoLungs());
  PlanarLungSystem b = drawnOut(twoLungs());
  breathe(a, 2);
  breathe(b, 2);
  PlanarLungSystem c = b;
  breathe(b, 1);
  breathe(a, 1);
  breathe(c, 1);
  EXPECT_EQ(stateOf(a), stateOf(b));
  EXPECT_EQ(stateOf(a), stateOf(c));
}

}  // namespace
}  // namespace pleura::planar
