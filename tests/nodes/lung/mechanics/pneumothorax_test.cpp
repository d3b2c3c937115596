#include <cmath>
#include <vector>

#include <pleura/tests/nodes/lung/mechanics/breath.h>

namespace pleura {
namespace {

constexpr double kAtmosphere = 101325;

/// As much gas, at ambient pressure, as makes intrapleural pressure atmospheric.
double collapsingVolume(const BreathingLung& side) {
  return side.inputs.cavityVolume - side.unstretched() - side.now.film / kAtmosphere;
}

/// A lung of a closed pneumothorax of this share of the gas that makes it collapse.
BreathingLung closedPneumothorax(double share, const LungMechanics& lung = {}) {
  BreathingLung side(lung);
  side.inputs.leak.kind = Pneumothorax::closed;
  EXPECT_TRUE(admitGas(share * collapsingVolume(side), kAtmosphere, side.now));
  return side;
}

// Closed

TEST(ClosedPneumothorax, GasOfAtmosphericPressureLetsTheLungFallToItsUnstretchedVolume) {
  for (const LungMechanics& lung : {LungMechanics{}, sigmoidLung()}) {
    BreathingLung side = closedPneumothorax(1, lung);
    side.steps(2000, 0.01);
    EXPECT_NEAR(side.now.intrapleural, 0, 1e-6);
    EXPECT_NEAR(side.now.lungVolume, side.unstretched(), 1e-12);
  }
}

TEST(ClosedPneumothorax, ALittleGasLetsItFallALittle) {
  double last = 1.15 * kLitre;
  for (const double share : {0.1, 0.3, 0.6, 0.9}) {
    BreathingLung side = closedPneumothorax(share);
    side.steps(2000, 0.01);
    EXPECT_LT(side.now.lungVolume, last);
    EXPECT_LT(side.now.intrapleural, 0);
    last = side.now.lungVolume;
  }
  EXPECT_GT(last, 0.65 * kLitre);
}

TEST(ClosedPneumothorax, GasStaysAndKeepsPressureTimesVolume) {
  BreathingLung side = closedPneumothorax(0.5);
  const double gas = side.now.gas, content = gas + side.now.film;
  side.breathe(kOneToTwo, 40, 0.01, [&](double) {
    EXPECT_EQ(side.now.gas, gas);
    EXPECT_NEAR((kAtmosphere + side.now.intrapleural) * side.now.pleuralVolume(), content, 1e-12 * content);
  });
}

TEST(ClosedPneumothorax, TheLungStillFollowsButLess) {
  BreathingLung side = closedPneumothorax(0.5);
  double least = 1, most = 0;
  side.breathe(kOneToTwo, 40, 0.01, [&](double t) {
    if (t < 36) return;
    least = std::min(least, side.now.lungVolume);
    most = std::max(most, side.now.lungVolume);
  });
  EXPECT_LT(most - least, 0.2499 * kLitre);  // gas stretches little: 250 Pa of an atmosphere
  EXPECT_GT(most - least, 0.24 * kLitre);
}

TEST(AdmitGas, RefusesWhatIsNoVolume) {
  LungState state = restingState({});
  for (const double bad :
       {-1e-9, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(admitGas(bad, kAtmosphere, state));
    EXPECT_FALSE(admitGas(1e-4, bad, state));
  }
  EXPECT_EQ(state.gas, 0);
}

// Open

TEST(OpenPneumothorax, PressureTendsToAtmosphericAndTheLungToUnstretched) {
  for (const LungMechanics& lung : {LungMechanics{}, sigmoidLung()})
    for (const double area : {1e-7, 1e-5, 1e-3}) {
      BreathingLung side(lung);
      side.inputs.leak = wound(Pneumothorax::open, area);
      side.steps(20'000, 0.1);
      EXPECT_NEAR(side.now.intrapleural, 0, 1e-6);
      EXPECT_NEAR(side.now.lungVolume, side.unstretched(), 1e-12);
    }
}

TEST(OpenPneumothorax, OneLongestStepIsTheStaticAnswer) {
  BreathingLung side;
  side.inputs.leak = wound(Pneumothorax::open, 1e-3);
  side.step(kLongestStep);
  EXPECT_NEAR(side.now.lungVolume, side.unstretched(), 0.2e-6);  // R C / dt of the way is left
  EXPECT_NEAR(side.now.intrapleural, 0, 1e-3);
}

// Through a large wound p = 0 at once: R dV/dt = -P,  V = V_0 + (V_F - V_0) exp(-t / (R C)).
TEST(OpenPneumothorax, ThroughALargeWoundTheLungFallsWithTheTimeConstantRC) {
  const auto error = [](double dt) {
    BreathingLung side;
    side.inputs.leak = wound(Pneumothorax::open, 1);
    side.steps(static_cast<int>(std::lround(0.45 / dt)), dt);
    const double rc = side.lung.airwayResistance * side.lung.recoil.rest().compliance;
    EXPECT_NEAR(rc, 0.3, 1e-12);
    const double exact = 0.65 * kLitre + 0.5 * kLitre * std::exp(-0.45 / rc);
    return std::abs(side.now.lungVolume - exact);
  };
  EXPECT_LT(error(1e-4), 1e-4 * 0.5 * kLitre);
  EXPECT_NEAR(std::log2(error(0.01) / error(0.005)), 1, 0.05);
}

// Through a small one the bronchus counts for nothing: with u = V - V_0,
//   du/dt = -C_d A sqrt(2 u / (C rho)),  T = (2 / (C_d A)) sqrt(u_F C rho / 2)  until u = 0,
// and half of sqrt(u_F) is left at T / 2.
TEST(OpenPneumothorax, ThroughASmallWoundTheSquareRootOfTheStretchFallsEvenly) {
  BreathingLung side;
  const double C = side.lung.recoil.rest().compliance, uF = 0.5 * kLitre;
  side.inputs.leak = wound(Pneumothorax::open, 1e-7);
  const double T = 2 / (0.6 * 1e-7) * std::sqrt(uF * C * kAirDensity / 2);
  side.steps(20'000, T / 40'000);
  // The gas is rarefied by up to 0.5 %, and fills as much more.
  EXPECT_NEAR(std::sqrt((side.now.lungVolume - 0.65 * kLitre) / uF), 0.5, 0.01);
  side.steps(22'000, T / 40'000);
  EXPECT_NEAR(side.now.lungVolume, 0.65 * kLitre, 0.001 * kLitre);
}

TEST(OpenPneumothorax, AirGoesInAndOutThroughTheWoundInsteadOfTheMouth) {
  BreathingLung side;
  side.inputs.leak = wound(Pneumothorax::open, 1e-3);
  double in = 0, out = 0, mouth = 0;
  side.breathe(kOneToTwo, 12, 0.01, [&](double t) {
    if (t < 8) return;
    in = std::max(in, side.now.woundFlow);
    out = std::min(out, side.now.woundFlow);
    mouth = std::max(mouth, std::abs(side.now.airFlow));
  });
  EXPECT_NEAR(in / kLitre, 0.295, 0.01);  // all that the cavity asks for
  EXPECT_NEAR(out / kLitre, -0.147, 0.01);
  EXPECT_LT(mouth / kLitre, 0.001);
}

TEST(OpenPneumothorax, ASmallerWoundMovesLessOfTheBreath) {
  double last = 0;
  for (const double area : {1e-3, 1e-4, 3e-5, 1e-5, 1e-6}) {
    BreathingLung side;
    side.inputs.leak = wound(Pneumothorax::open, area);
    double least = 1, most = 0;
    side.breathe(kOneToTwo, 200, 0.01, [&](double t) {
      if (t < 196) return;
      least = std::min(least, side.now.lungVolume);
      most = std::max(most, side.now.lungVolume);
    });
    EXPECT_GT(most - least, last);
    last = most - least;
  }
  EXPECT_GT(last, 0.2 * kLitre);
}

// Tension

class Tension : public testing::TestWithParam<LeakSource> {
 protected:
  BreathingLung side(double area) const {
    BreathingLung made;
    made.inputs.leak = wound(Pneumothorax::tension, area);
    made.inputs.leak.source = GetParam();
    return made;
  }
};

TEST_P(Tension, GasComesInAndNeverLeaves) {
  BreathingLung torn = side(1e-5);
  double last = 0;
  torn.breathe(kOneToTwo, 80, 0.01, [&](double) {
    EXPECT_GE(torn.now.gas, last);
    EXPECT_GE(torn.now.woundFlow, 0);
    EXPECT_GE(torn.now.tearFlow, 0);
    last = torn.now.gas;
  });
  EXPECT_GT(last, 0);
}

TEST_P(Tension, PressureRisesAboveAtmosphericAsInEachExhaleTheGasIsPressed) {
  BreathingLung torn = side(1e-5);
  double highest = -1e9;
  torn.breathe(kOneToTwo, 80, 0.01, [&](double) { highest = std::max(highest, torn.now.intrapleural); });
  EXPECT_GT(highest, 2 * kCmH2O);
  EXPECT_LT(torn.now.lungVolume, torn.unstretched());
}

// No more gas comes in once p = 0 and V = V_0 at the top, where V_c is largest: the most is p_0 (V_c,max -
// V_0), and what p is at the bottom is the root of (p_0 + p) (V_c,min - V(-p)) = that.
TEST_P(Tension, ItsLimitIsThatOfTheTopOfTheBreath) {
  BreathingLung torn = side(1e-4);
  const Breath slow{.period = 60};
  torn.breathe(slow, 1800, 0.05);
  const double most = kAtmosphere * (restingCavity(torn.lung) + slow.depth - torn.unstretched());
  EXPECT_LE(torn.now.gas + torn.now.film, 1.001 * most);  // the bronchus makes up for 0.01 %
  EXPECT_GT(torn.now.gas + torn.now.film, 0.999 * most);
  double low = 0, high = 2000;
  while (high - low > 1e-9) {
    const double p = 0.5 * (low + high);
    const double held = (kAtmosphere + p) * (restingCavity(torn.lung) - torn.lung.recoil.volume(-p));
    (held < most ? low : high) = p;
  }
  EXPECT_NEAR(torn.now.intrapleural, low, 0.02 * low);
  EXPECT_GT(low, 2.4 * kCmH2O);
}

INSTANTIATE_TEST_SUITE_P(From, Tension, testing::Values(LeakSource::wound, LeakSource::lung),
                         [](const auto& about) {
                           return about.param == LeakSource::wound ? "wound" : "lung";
                         });

// Drain

TEST(Drain, BringsACollapsedLungBackUntilTheGasIsGone) {
  for (const LungMechanics& lung : {LungMechanics{}, sigmoidLung()}) {
    BreathingLung side = closedPneumothorax(1, lung);
    side.steps(1000, 0.01);
    side.inputs.drain.isOn = true;
    side.breathe(kOneToTwo, 60, 0.01);
    EXPECT_EQ(side.now.gas, 0);
    EXPECT_NEAR(side.now.lungVolume, 1.15 * kLitre, 1e-9);
    EXPECT_EQ(side.now.drainFlow, 0);
    // a breath later all is as if it had never been
    BreathingLung healthy;
    healthy.lung = lung;
    healthy.now = restingState(lung);
    healthy.breathe(kOneToTwo, 60, 0.01);
    EXPECT_NEAR(side.now.intrapleural, healthy.now.intrapleural, 1e-6);
  }
}

TEST(Drain, NeverLetsAnythingBackIn) {
  BreathingLung side = closedPneumothorax(0.5);
  side.inputs.drain = {.isOn = true, .suction = 0};
  double last = side.now.gas;
  side.breathe({.depth = 1 * kLitre}, 20, 0.01, [&](double) {
    EXPECT_LE(side.now.gas, last);
    last = side.now.gas;
  });
}

// Quasi-static, with u = V - V_0, suction s and tube resistance R_d:
//   du/dt = (s - u / C) / R_d,  t = R_d C ln(s C / (s C - u_F))  until u = u_F and the gas is gone.
TEST(Drain, TakesTheTimeOfTubeAndCompliance) {
  BreathingLung side = closedPneumothorax(1);
  side.steps(5000, 0.01);
  const double C = side.lung.recoil.rest().compliance, suction = 20 * kCmH2O,
               Rd = 1e8;  // slow beside the bronchus
  side.inputs.drain = {.isOn = true, .suction = suction, .resistance = Rd};
  const double exact = Rd * C * std::log(suction * C / (suction * C - 0.5 * kLitre));
  double t = 0;
  for (; side.now.gas > 0; t += 1e-2) side.step(1e-2);
  EXPECT_NEAR(t, exact, 0.015 * exact);  // bronchus 0.3 %, rarefaction up to 0.5 %
}

TEST(Drain, WithTooLittleSuctionItStopsHalfWay) {
  BreathingLung side = closedPneumothorax(1);
  side.inputs.drain = {.isOn = true, .suction = 2 * kCmH2O};
  side.steps(20'000, 0.01);
  EXPECT_NEAR(side.now.intrapleural, -2 * kCmH2O, 1e-6);
  EXPECT_NEAR(side.now.lungVolume, 0.85 * kLitre, 1e-9);
}

// Gas is counted

TEST(PleuralGas, IsWhatCameInLessWhatLeftAtAnyStep) {
  for (const double dt : {1e-6, 1e-3, 0.05, 2.0, 1e3}) {
    BreathingLung side = closedPneumothorax(0.3);
    for (int k = 0; k < 4000; ++k) {
      side.inputs.leak = wound(static_cast<Pneumothorax>(k / 500 % 4), 2e-5);
      side.inputs.leak.source = k % 2000 < 1000 ? LeakSource::wound : LeakSource::lung;
      side.inputs.drain.isOn = k % 300 > 200;
      side.hold(kOneToTwo.at(k * 0.01));
      const LungState before = side.now;
      side.step(dt);
      const double flow = side.now.woundFlow + side.now.tearFlow - side.now.drainFlow;
      const double scale =
          side.now.gas + before.gas + kAtmosphere * dt * (std::abs(side.now.woundFlow) + side.now.drainFlow);
      ASSERT_NEAR(side.now.gas, before.gas + kAtmosphere * dt * flow, 4e-16 * scale + 1e-300)
          << k << " " << dt;
      const double content = side.now.gas + side.now.film;
      ASSERT_NEAR((kAtmosphere + side.now.intrapleural) * side.now.pleuralVolume(), content,
                  1e-9 * content + 1e-12);
      // and the lung keeps its own account
      ASSERT_NEAR(side.now.lungVolume, before.lungVolume + dt * (side.now.airFlow - side.now.tearFlow),
                  1e-16 + 1e-15 * dt);
    }
  }
}

}  // namespace
}  // namespace pleura
