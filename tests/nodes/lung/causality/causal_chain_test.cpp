#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include <pleura/nodes/lung/causality/causal_chain.h>
#include <pleura/tests/nodes/lung/mechanics/breath.h>

namespace pleura {
namespace {

constexpr int kAll = kQuantities;
const char* const kNames[kAll] = {
    "muscle force",      "cavity volume", "intrapleural pressure", "transpulmonary pressure", "lung volume",
    "alveolar pressure", "air flow"};

/// What each quantity's change is, by its own numbers.
PerQuantity<double> ratesOf(const LungState& before, const LungState& now, double dt) {
  PerQuantity<double> rate;
  rate[Quantity::muscleForce] = rate[Quantity::cavityVolume] = (now.cavityVolume - before.cavityVolume) / dt;
  rate[Quantity::intrapleural] = (now.intrapleural - before.intrapleural) / dt;
  rate[Quantity::transpulmonary] = (now.transpulmonary - before.transpulmonary) / dt;
  rate[Quantity::lungVolume] = (now.lungVolume - before.lungVolume) / dt;
  rate[Quantity::alveolar] = (now.alveolar - before.alveolar) / dt;
  rate[Quantity::airFlow] = (now.airFlow - before.airFlow) / dt;
  return rate;
}

PerQuantity<double> bandsOf(const DeadBands& band) {
  return {
      {band.volume, band.volume, band.pressure, band.pressure, band.volume, band.pressure, band.flowChange}};
}

struct Tally {
  int moments = 0;
  PerQuantity<int> determined{};
  double share(Quantity q) const { return static_cast<double>(determined[q]) / moments; }
};

/// Holds one moment's derived signs against the numbers.
void compare(const CausalChain& chain, const BreathingLung& side, const LungState& before, double dt,
             Tally& tally) {
  const PerQuantity<double> rate = ratesOf(before, side.now, dt);
  const PerQuantity<double> band = bandsOf(deadBands(side.lung, side.now));
  ++tally.moments;
  for (int k = 0; k < kAll; ++k) {
    const auto q = static_cast<Quantity>(k);
    const SignSet measured = SignSet::of(rate[q], band[q]), derived = chain.derived[q];
    ASSERT_FALSE((measured & derived).isEmpty()) << kNames[k] << " changes by " << rate[q];
    if (!derived.isOne()) continue;
    ++tally.determined[q];
    if (!measured.isOne()) continue;
    ASSERT_EQ(measured, derived) << kNames[k] << " changes by " << rate[q];
    ASSERT_TRUE(derived.contains(chain.change[q])) << kNames[k];
  }
}

struct Case {
  std::string name;
  std::function<void(BreathingLung&)> prepare = [](BreathingLung&) {};
};

const std::vector<Case>& cases() {
  static const auto closed = [](double share) {
    return [share](BreathingLung& side) {
      side.inputs.leak.kind = Pneumothorax::closed;
      admitGas(share * (side.inputs.cavityVolume - side.unstretched()), 101325, side.now);
    };
  };
  static const auto leak = [](Pneumothorax kind, double area, LeakSource source = LeakSource::wound) {
    return [=](BreathingLung& side) {
      side.inputs.leak = wound(kind, area);
      side.inputs.leak.source = source;
    };
  };
  static const std::vector<Case> all = {
      {"healthy"},
      {"closedHalf", closed(0.5)},
      {"closedFull", closed(1)},
      {"openLarge", leak(Pneumothorax::open, 1e-3)},
      {"openSmall", leak(Pneumothorax::open, 3e-6)},
      {"tensionFromWound", leak(Pneumothorax::tension, 1e-5)},
      {"tensionFromLung", leak(Pneumothorax::tension, 1e-5, LeakSource::lung)},
      {"drained", [](BreathingLung& side) {
         closed(1)(side);
         side.inputs.drain.isOn = true;
       }}};
  return all;
}

struct Pattern {
  const char* name;
  Breath breath;
};

const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> all = {{"sinusoid", {}},
                                           {"oneToTwo", kOneToTwo},
                                           {"deep", {.depth = 1.4 * kLitre}},
                                           {"deepOneToTwo", {.depth = 1.4 * kLitre, .inspiration = 1.0 / 3}},
                                           {"pausedOnTheWayIn", {.pauseFrom = 4.7, .pauseFor = 1.5}},
                                           {"pausedAtTheTop", {.pauseFrom = 6, .pauseFor = 1.5}},
                                           {"pausedOnTheWayOut", {.pauseFrom = 7.1, .pauseFor = 1.5}}};
  return all;
}

class WholeBreath : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {
 protected:
  Tally run(const LungMechanics& lung, double dt) {
    const auto& [name, breath] = patterns()[std::get<1>(GetParam())];
    BreathingLung side(lung);
    cases()[std::get<0>(GetParam())].prepare(side);
    Tally tally;
    LungState before = side.now;
    side.breathe(breath, 12, dt, [&](double t) {
      SCOPED_TRACE(std::to_string(t) + " s, step " + std::to_string(dt));
      if (!HasFatalFailure())
        compare(causalChain(lung, side.inputs, before, side.now, dt), side, before, dt, tally);
      before = side.now;
    });
    return tally;
  }
};

TEST_P(WholeBreath, WhatIsDerivedIsWhatTheNumbersDo) {
  for (const LungMechanics& lung : {LungMechanics{}, sigmoidLung()})
    for (const double dt : {3e-4, 1.0 / 60, 0.1}) {
      const Tally tally = run(lung, dt);
      ASSERT_FALSE(HasFatalFailure());
      EXPECT_GT(tally.share(Quantity::cavityVolume), 0.95);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Of, WholeBreath, testing::Combine(testing::Range<std::size_t>(0, 8), testing::Range<std::size_t>(0, 7)),
    [](const auto& about) {
      return cases()[std::get<0>(about.param)].name + "_" + patterns()[std::get<1>(about.param)].name;
    });

// With no gas, or gas that stays, the chain is all but complete. Intrapleural pressure is open to it half of
// the time: while the air flow slackens, recoil and flow push it different ways.
TEST(CausalChain, IsDeterminedNearlyAlwaysWhereTheLungFollows) {
  for (const bool isClosed : {false, true})
    for (const Breath& breath : {Breath{}, kOneToTwo}) {
      BreathingLung side;
      if (isClosed) admitGas(0.2 * kLitre, 101325, side.now);
      side.steps(600, 0.01);
      Tally tally;
      LungState before = side.now;
      side.breathe(breath, 12, 0.01, [&](double) {
        compare(causalChain(side.lung, side.inputs, before, side.now, 0.01), side, before, 0.01, tally);
        before = side.now;
      });
      for (int k = 0; k < kAll; ++k) {
        const auto q = static_cast<Quantity>(k);
        EXPECT_GT(tally.share(q), q == Quantity::intrapleural ? 0.48 : 0.94) << kNames[k] << isClosed;
      }
    }
}

/// The chain after a breath has gone on for some time.
CausalChain chainAt(double t, const Breath& breath = {}, BreathingLung side = {}, double dt = 0.01) {
  LungState before = side.now;
  CausalChain chain;
  side.breathe(breath, t, dt, [&](double) {
    chain = causalChain(side.lung, side.inputs, before, side.now, dt);
    before = side.now;
  });
  return chain;
}

using Signs = std::array<int, kAll>;

Signs signs(const PerQuantity<Sign>& change) {
  Signs all;
  std::transform(change.begin(), change.end(), all.begin(), [](Sign sign) { return static_cast<int>(sign); });
  return all;
}

/// 9 where more than one is allowed.
Signs signs(const PerQuantity<SignSet>& derived) {
  Signs all;
  std::transform(derived.begin(), derived.end(), all.begin(), [](SignSet set) {
    for (const Sign sign : {Sign::falls, Sign::stands, Sign::rises})
      if (set == SignSet(sign)) return static_cast<int>(sign);
    return 9;
  });
  return all;
}

// muscles, cavity, intrapleural, transpulmonary, lung, alveolar, flow
TEST(CausalChain, AsTheBreathBeginsItIsThatOfTheSource) {
  const Signs inspiration = {1, 1, -1, 1, 1, -1, 1};
  EXPECT_EQ(signs(chainAt(0.5).derived), inspiration);
  EXPECT_EQ(signs(chainAt(0.5).change), inspiration);
  EXPECT_EQ(chainAt(0.5).air, Sign::rises);
  const Signs expiration = {-1, -1, 1, -1, -1, 1, -1};
  EXPECT_EQ(signs(chainAt(2.5).derived), expiration);
  EXPECT_EQ(signs(chainAt(2.5).change), expiration);
  EXPECT_EQ(chainAt(2.5).air, Sign::falls);
}

TEST(CausalChain, AsTheFlowSlackensIntrapleuralPressureIsOpenAndTheNumbersDecide) {
  const Signs late = {1, 1, 9, 1, 1, 1, -1};
  EXPECT_EQ(signs(chainAt(1.4).derived), late);
  EXPECT_EQ(signs(chainAt(1.95).derived), late);
  EXPECT_EQ(chainAt(1.4).change[Quantity::intrapleural], Sign::falls);   // recoil is more
  EXPECT_EQ(chainAt(1.95).change[Quantity::intrapleural], Sign::rises);  // flow is more
}

TEST(CausalChain, TheBreathTurnsOnceAtEitherEnd) {
  EXPECT_TRUE(chainAt(2).isTurning);
  EXPECT_TRUE(chainAt(4).isTurning);
  for (const double t : {0.5, 1.0, 1.5, 2.5, 3.0, 3.5}) EXPECT_FALSE(chainAt(t).isTurning) << t;
  EXPECT_FALSE(chainAt(5, {.depth = 0}).isTurning);
}

TEST(CausalChain, InAPauseAllStands) {
  for (const double from : {0.7, 2.0, 3.1}) {
    const CausalChain chain = chainAt(from + 1, {.pauseFrom = from, .pauseFor = 5});
    EXPECT_EQ(signs(chain.derived), Signs{}) << from;
    EXPECT_EQ(signs(chain.change), Signs{}) << from;
    EXPECT_FALSE(chain.isTurning);
  }
}

TEST(CausalChain, TellsHowFarTheLungFollows) {
  BreathingLung side;
  EXPECT_EQ(chainAt(5, {}, side).following, Following::fully);
  EXPECT_EQ(chainAt(5, {.depth = 0}, side).following, Following::unasked);
  side.inputs.leak = wound(Pneumothorax::open, 5e-6);
  EXPECT_EQ(chainAt(201, {}, side).following, Following::partly);
  side.inputs.leak = wound(Pneumothorax::open, 1e-3);
  const CausalChain open = chainAt(20.5, {}, side);
  EXPECT_EQ(open.following, Following::hardly);
  EXPECT_EQ(open.pleuralGas, Sign::rises);
  EXPECT_FALSE(open.isCoupled);
  EXPECT_TRUE(open.hasGas);
}

TEST(CausalChain, ATensionPneumothoraxIsAboveAtmosphericWhenTheCavityIsSmall) {
  BreathingLung side;
  side.inputs.leak = wound(Pneumothorax::tension, 1e-4);
  EXPECT_EQ(chainAt(60, {}, side).pleuralGauge, Sign::rises);
  EXPECT_EQ(chainAt(0.5, {}, side).pleuralGauge, Sign::falls);
  EXPECT_EQ(chainAt(0.5, {}, side).pneumothorax, Pneumothorax::tension);
}

TEST(DeadBands, FollowFromPressureByComplianceAndResistance) {
  const BreathingLung side;
  const DeadBands band = deadBands(side.lung, side.now, 2);
  EXPECT_EQ(band.pressure, 2);
  EXPECT_DOUBLE_EQ(band.volume, 2 * side.lung.recoil.rest().compliance);
  EXPECT_DOUBLE_EQ(band.flowChange, 2 / side.lung.airwayResistance);
}

}  // namespace
}  // namespace pleura
