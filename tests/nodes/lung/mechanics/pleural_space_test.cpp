#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>

#include <pleura/tests/nodes/lung/mechanics/breath.h>

namespace pleura {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double cmH2O(double pascals) { return pascals / kCmH2O; }
double litres(double cubicMetres) { return cubicMetres / kLitre; }

// NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the sign of a zero counts, and a NaN is its equal
bool isSameBits(const LungState& a, const LungState& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST(PleuralSpace, ALungLeftAloneStaysAtRest) {
  for (const double dt : {1e-6, 1e-3, 1.0, 1e3})
    for (const LungMechanics& lung : {LungMechanics{}, sigmoidLung()}) {
      BreathingLung side(lung);
      side.steps(1000, dt);
      EXPECT_NEAR(side.now.lungVolume, 1.15 * kLitre, 1e-15);
      EXPECT_NEAR(side.now.intrapleural, -5 * kCmH2O, 1e-6);
      EXPECT_NEAR(side.now.alveolar, 0, 1e-6);
    }
}

struct QuietBreath {
  const char* name;
  Breath breath;
  double resistance;  // [cmH2O s/L] of both lungs
  LungMechanics lung;
};

class Quiet : public testing::TestWithParam<QuietBreath> {};

// What comes out: intrapleural pressure at the end of inspiration -7.50 (linear) or -7.44 cmH2O (sigmoid),
// lowest on the way there -7.56 to -7.97; alveolar within 0.40 to 1.17, the most with one to two and 1.99
// cmH2O s/L.
TEST_P(Quiet, PressuresFlowAndVolumeAreThoseMeasured) {
  LungMechanics lung = GetParam().lung;
  lung.airwayResistance = 2 * GetParam().resistance * kCmH2O / kLitre;
  BreathingLung left(lung), right(lung);
  EXPECT_NEAR(litres(left.now.lungVolume + right.now.lungVolume), 2.3, 1e-9);
  EXPECT_EQ(cmH2O(left.now.intrapleural), -5);
  double most = 0, least = 1, atTop = 0, lowest = 0, highest = -kInfinity, alveolar = 0, in = 0, out = 0;
  left.breathe(GetParam().breath, 8, 1e-3, [&](double t) {
    right.inputs.cavityVolume = left.inputs.cavityVolume;
    right.step(1e-3);
    if (t < 4) return;
    const double volume = left.now.lungVolume + right.now.lungVolume;
    if (volume > most) most = volume, atTop = left.now.intrapleural;
    least = std::min(least, volume);
    lowest = std::min(lowest, left.now.intrapleural);
    highest = std::max(highest, left.now.intrapleural);
    alveolar = std::max(alveolar, std::abs(left.now.alveolar));
    in = std::max(in, left.now.airFlow + right.now.airFlow);
    out = std::min(out, left.now.airFlow + right.now.airFlow);
  });
  EXPECT_NEAR(litres(most - least), 0.5, 0.001);
  EXPECT_NEAR(cmH2O(atTop), -7.5, 0.1);
  EXPECT_GT(cmH2O(lowest), -8);
  EXPECT_LT(cmH2O(lowest), -7.5);
  EXPECT_NEAR(cmH2O(highest), -4.9, 0.15);
  EXPECT_GT(cmH2O(alveolar), 0.35);
  EXPECT_LT(cmH2O(alveolar), 1.8);
  const double share = GetParam().breath.inspiration,
               peak = 0.25 * std::numbers::pi;  // of a half-cosine of 0.5 L
  EXPECT_NEAR(litres(in), peak / (4 * share), 0.001);
  EXPECT_NEAR(litres(out), -peak / (4 * (1 - share)), 0.001);
}

INSTANTIATE_TEST_SUITE_P(
    Breathing, Quiet,
    testing::Values(QuietBreath{"sinusoid", {}, 1.5, {}}, QuietBreath{"oneToTwo", kOneToTwo, 1.5, {}},
                    QuietBreath{"oneToTwoLeastResistance", kOneToTwo, 1.01, {}},
                    QuietBreath{"oneToTwoMostResistance", kOneToTwo, 1.99, {}},
                    QuietBreath{"sinusoidSigmoid", {}, 1.5, sigmoidLung()},
                    QuietBreath{"oneToTwoSigmoidMostResistance", kOneToTwo, 1.99, sigmoidLung()}),
    [](const auto& about) { return about.param.name; });

TEST(PleuralSpace, EachStepHoldsItsEquations) {
  BreathingLung side(sigmoidLung());
  side.inputs.leak = wound(Pneumothorax::open, 1e-6);
  double last = side.now.lungVolume;
  side.breathe(kOneToTwo, 8, 0.01, [&](double) {
    const LungState& s = side.now;
    EXPECT_NEAR(s.transpulmonary, s.alveolar - s.intrapleural, 1e-9);
    EXPECT_NEAR(s.lungVolume, side.lung.recoil.volume(s.transpulmonary), 1e-18);
    EXPECT_NEAR(s.airFlow, (s.lungVolume - last) / 0.01, 1e-16);
    EXPECT_NEAR(s.alveolar, -side.lung.airwayResistance * s.airFlow, 1e-9);
    EXPECT_NEAR((101325 + s.intrapleural) * s.pleuralVolume(), s.film + s.gas, 1e-11);
    last = s.lungVolume;
  });
}

TEST(PleuralSpace, TheLungFollowsTheCavityWithinThousandthsOfAMicrolitre) {
  BreathingLung side;
  side.breathe({.depth = 1.4 * kLitre}, 4, 1e-3, [&](double) {
    EXPECT_NEAR(side.now.pleuralVolume(), side.lung.filmVolume, 0.05 * side.lung.filmVolume);
    EXPECT_NEAR(side.now.cavityVolume - side.inputs.cavityVolume, 0, 0);
  });
}

TEST(PleuralSpace, AmbientPressureIsApartFromGauge) {
  BreathingLung low, high;
  high.inputs.ambientPressure = 3 * 101325;  // in a pressure chamber; the film was made at sea level
  low.breathe(kOneToTwo, 4, 1e-2);
  high.breathe(kOneToTwo, 4, 1e-2);
  EXPECT_NEAR(low.now.intrapleural, high.now.intrapleural, 1);  // 0.67 uL of film are 0.7 Pa of recoil
}

TEST(PleuralSpace, LungsAreIndependent) {
  BreathingLung alone, left, right;
  left.inputs.leak = wound(Pneumothorax::open, 1e-4);
  for (int k = 0; k < 1000; ++k) {
    const double volume = kOneToTwo.at(k * 0.01);
    for (BreathingLung* side : {&left, &right, &alone}) side->hold(volume), side->step(0.01);
  }
  EXPECT_TRUE(isSameBits(right.now, alone.now));
  EXPECT_LT(left.now.lungVolume, 0.7 * kLitre);
}

TEST(PleuralSpace, ConvergesWithOrderOneInTime) {
  // p = -(P_F + (V - V_F) / C) - R dV/dt with the volume imposed
  const auto error = [](double dt) {
    BreathingLung side;
    side.breathe({}, 1.5, dt);
    const double w = std::numbers::pi / 2, volume = side.now.lungVolume - 1.15 * kLitre;
    const double flow = 0.125 * kLitre * w * std::sin(w * 1.5);
    const double exact = -side.lung.recoil.rest().recoil - volume / side.lung.recoil.rest().compliance -
                         side.lung.airwayResistance * flow;
    return std::abs(side.now.intrapleural - exact);
  };
  for (const double dt : {0.02, 0.01, 0.005})
    EXPECT_NEAR(std::log2(error(dt) / error(dt / 2)), 1, 0.05) << dt;
}

TEST(PleuralSpace, TheLongestStepIsTheStaticAnswer) {
  for (const LungMechanics& lung : {LungMechanics{}, sigmoidLung()})
    for (const double volume : {-0.3 * kLitre, 0.25 * kLitre, 1.5 * kLitre}) {
      BreathingLung side(lung);
      side.hold(volume);
      side.step(kLongestStep);
      // what is left of flow is R dV / dt: up to 0.45 Pa
      EXPECT_NEAR(side.now.alveolar, 0, 0.5);
      const double flowing = side.now.alveolar;
      side.step(kLongestStep);
      EXPECT_NEAR(side.now.alveolar, 0, 1e-3 * std::abs(flowing));
      EXPECT_NEAR(side.now.lungVolume, 1.15 * kLitre + volume, 0.05e-6);
      EXPECT_NEAR(lung.recoil.volume(-side.now.intrapleural), side.now.lungVolume, 1e-9);
    }
}

TEST(PleuralSpace, AMillionStepsDoNotDrift) {
  BreathingLung side(sigmoidLung());
  LungState first;
  side.breathe(kOneToTwo, 8, 4e-3,
               [&](double) { first = side.now; });  // from the second breath on all are alike
  side.breathe(kOneToTwo, 4000, 4e-3);
  EXPECT_NEAR(side.now.lungVolume, first.lungVolume, 1e-15);
  EXPECT_NEAR(side.now.intrapleural, first.intrapleural, 1e-6);
  EXPECT_EQ(side.now.film, first.film);
}

TEST(PleuralSpace, RepeatsBitForBit) {
  const auto run = [] {
    BreathingLung side(sigmoidLung());
    side.inputs.leak = wound(Pneumothorax::open, 3e-6);
    side.breathe(kOneToTwo, 20, 7e-3);
    return side.now;
  };
  EXPECT_TRUE(isSameBits(run(), run()));
}

TEST(PleuralSpace, WhatIsNoNumberIsRefusedAndTheStateKept) {
  BreathingLung side;
  side.breathe(kOneToTwo, 1, 1e-2);
  const PleuralInputs sound = side.inputs;
  const auto isRefused = [&](double dt = 0.01) {
    const LungState before = side.now;
    const PleuralReport report = advance(side.lung, side.inputs, dt, side.now);
    side.inputs = sound;
    return !report.isAccepted && !report.hasConverged && isSameBits(before, side.now);
  };
  for (const double bad : {kNan, kInfinity, -kInfinity, -1.0}) {
    EXPECT_TRUE(isRefused(bad));
    side.inputs.cavityVolume = bad;
    EXPECT_TRUE(isRefused());
    side.inputs.ambientPressure = bad;
    EXPECT_TRUE(isRefused());
    side.inputs.leak.hole.area = bad;
    EXPECT_TRUE(isRefused());
    side.inputs.leak.hole.dischargeCoefficient = bad;
    EXPECT_TRUE(isRefused());
    side.inputs.drain = {.isOn = true, .suction = bad};
    EXPECT_TRUE(isRefused());
    side.inputs.drain = {.isOn = true, .resistance = bad};
    EXPECT_TRUE(isRefused());
  }
  EXPECT_TRUE(isRefused(0));
  EXPECT_TRUE(isRefused(0.9 * kShortestStep));
  EXPECT_TRUE(isRefused(1.1 * kLongestStep));
  for (const double bad : {0.0, 0.9e-9, 1.1}) {
    side.inputs.cavityVolume = bad;
    EXPECT_TRUE(isRefused());
  }
  side.step(0.01);  // and goes on
}

TEST(PleuralSpace, LungsThatAreNoneAreRefusedAtSetUp) {
  for (const double bad : {kNan, kInfinity, 0.0, -1.0}) {
    LungMechanics lung;
    lung.airwayResistance = bad;
    EXPECT_THROW(restingState(lung), std::invalid_argument);
    lung = {};
    lung.filmVolume = bad;
    EXPECT_THROW(restingState(lung), std::invalid_argument);
    EXPECT_THROW(restingState({}, bad), std::invalid_argument);
  }
  EXPECT_THROW(restingState({}, 100), std::invalid_argument);  // less than the recoil
}

// More where a wound's flow turns, as a square root does at zero.
TEST(PleuralSpace, NewtonTakesAFewIterationsAStep) {
  for (const auto kind :
       {Pneumothorax::none, Pneumothorax::closed, Pneumothorax::open, Pneumothorax::tension})
    for (const double dt : {1e-3, 1.0 / 60}) {
      BreathingLung side(sigmoidLung());
      side.inputs.leak = wound(kind, 1e-5);
      int most = 0, sum = 0;
      for (int k = 1; k <= 4000; ++k) {
        side.hold(kOneToTwo.at(k * dt));
        const int iterations = advance(side.lung, side.inputs, dt, side.now).iterations;
        most = std::max(most, iterations);
        sum += iterations;
      }
      const bool isSealed = kind == Pneumothorax::none || kind == Pneumothorax::closed;
      EXPECT_LE(most, isSealed ? 5 : 40);
      EXPECT_LE(sum, 5 * 4000);
    }
}

// Any sound input, however wild its sequence, at any step.
TEST(PleuralSpace, ConvergesFromAnywhereToAnywhere) {
  std::mt19937_64 random(7);
  const auto between = [&](double least, double most) {
    return least + (most - least) * std::generate_canonical<double, 53>(random);
  };
  int most = 0;
  for (const LungMechanics& lung : {LungMechanics{}, sigmoidLung()}) {
    BreathingLung side(lung);
    for (int k = 0; k < 200'000; ++k) {
      side.inputs.cavityVolume = std::pow(10, between(-7, 0));
      side.inputs.ambientPressure = std::pow(10, between(3, 7));
      side.inputs.leak.kind = static_cast<Pneumothorax>(random() % 4);
      side.inputs.leak.source = static_cast<LeakSource>(random() % 2);
      side.inputs.leak.hole.area = std::pow(10, between(-12, 0));
      side.inputs.drain = {random() % 4 == 0, between(0, 0.99) * side.inputs.ambientPressure,
                           std::pow(10, between(0, 15))};
      if (random() % 64 == 0) side.now = restingState(lung);
      const LungState before = side.now;
      const PleuralReport report = advance(lung, side.inputs, std::pow(10, between(-6, 3)), side.now);
      ASSERT_TRUE(report.isAccepted);
      ASSERT_TRUE(report.hasConverged) << k << " after " << report.iterations;
      most = std::max(most, report.iterations);
      ASSERT_GE(side.now.lungVolume, 0);
      ASSERT_GT(side.now.pleuralVolume(), 0);
      ASSERT_GT(side.now.intrapleural, -side.inputs.ambientPressure);
      ASSERT_GE(side.now.gas, 0);
      ASSERT_EQ(side.now.film, before.film);
    }
  }
  EXPECT_LE(most, 110);  // of which bisection from the widest bracket is most
}

}  // namespace
}  // namespace pleura
