#include <cmath>

#include <gtest/gtest.h>

#include <pleura/nodes/deformable/springs/spring_interior.h>

namespace pleura {
namespace {

constexpr double kRest = 2;  // [m^3]
const VolumeHold kHold{30, 500};

// -dW/dV and -dp/dV by central differences.
void expectDerivatives(const SpringInterior& interior, double volume) {
  const double h = 1e-5 * std::abs(volume) + 1e-9;
  const InteriorState below = interiorAt(interior, kHold, volume - h, kRest),
                      here = interiorAt(interior, kHold, volume, kRest),
                      above = interiorAt(interior, kHold, volume + h, kRest);
  EXPECT_NEAR((below.energy - above.energy) / (2 * h), here.pressure, 1e-5 * (1 + std::abs(here.pressure)));
  EXPECT_NEAR((below.pressure - above.pressure) / (2 * h), here.slope, 1e-5 * (1 + here.slope));
  EXPECT_GE(here.slope, 0);
}

TEST(SpringInterior, PressureIsTheSlopeOfTheEnergy) {
  for (const SpringInterior& interior :
       {SpringInterior(EmptyInterior()), SpringInterior(GasInterior{100, 40}),
        SpringInterior(PressureInterior{-70}), SpringInterior(VolumeInterior())})
    for (const double volume : {0.01, 1.0, 2.0, 7.0}) expectDerivatives(interior, volume);
  for (const double volume : {1.5e-4, -1e-4, -3.0}) expectDerivatives(GasInterior{1e-3, 40}, volume);
}

TEST(SpringInterior, EnergyIsNothingAtRest) {
  EXPECT_EQ(interiorAt(GasInterior{100, 40}, kHold, kRest, kRest).energy, 0);
  EXPECT_EQ(interiorAt(PressureInterior{5}, kHold, kRest, kRest).energy, 0);
  EXPECT_EQ(interiorAt(VolumeInterior(), kHold, kRest, kRest).energy, 0);
}

TEST(SpringInterior, PressureTimesVolumeOfAGasIsConstant) {
  for (const double volume : {1e-3, 0.1, 1.0, 2.0, 50.0}) {
    const InteriorState state = interiorAt(GasInterior{100, 40}, {}, volume, kRest);
    EXPECT_NEAR((state.pressure + 40) * volume, 100, 1e-10) << "absolute is gauge and ambient";
  }
}

TEST(SpringInterior, AGasWithoutVolumeStillPushesAndEverHarder) {
  for (const GasInterior& gas : {GasInterior{100, 40}, GasInterior{0, 101325}}) {
    double last = interiorAt(gas, {}, 2e-4, kRest).pressure;
    for (const double volume : {1e-4, 0.0, -1.0, -1e6}) {
      const InteriorState state = interiorAt(gas, {}, volume, kRest);
      EXPECT_TRUE(std::isfinite(state.energy));
      EXPECT_GT(state.pressure, last);
      EXPECT_TRUE(volume >= 0 || state.pressure > 0);
      last = state.pressure;
    }
  }
}

}  // namespace
}  // namespace pleura
