#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/lung/causality/causal_text.h>
#include <pleura/tests/nodes/lung/mechanics/breath.h>

namespace pleura {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// What is told after a breath has gone on for some time.
std::vector<std::string> toldAt(double t, const Breath& breath = {}, BreathingLung side = {}) {
  LungState before = side.now;
  std::vector<std::string> told;
  const double dt = 0.01;
  side.breathe(breath, t, dt, [&](double now) {
    if (now > t - 1.5 * dt) told = tell(causalChain(side.lung, side.inputs, before, side.now, dt));
    before = side.now;
  });
  return told;
}

TEST(CausalText, InspirationBegins) {
  EXPECT_THAT(
      toldAt(0.5),
      ElementsAre(
          "The breathing muscles pull harder.",
          "The chest cavity grows because the breathing muscles pull harder.",
          "The intrapleural pressure falls because the chest cavity grows and the alveolar pressure "
          "falls.",
          "The transpulmonary pressure rises because the intrapleural pressure falls, although the "
          "alveolar pressure falls.",
          "The lung widens because the transpulmonary pressure that stretches it rises.",
          "The alveolar pressure falls because the lung widens faster than air comes in.",
          "Air flows in, ever faster, because the alveolar pressure falls further below atmospheric."));
}

TEST(CausalText, InspirationEnds) {
  const auto told = toldAt(1.95);
  EXPECT_THAT(
      told,
      Contains("The intrapleural pressure rises because the alveolar pressure rises, although the chest "
               "cavity grows."));
  EXPECT_THAT(
      told, Contains("Air flows in, ever slower, because the alveolar pressure rises towards atmospheric."));
  EXPECT_THAT(toldAt(2).front(), StartsWith("The breath turns to expiration: the lung no longer widens"));
}

TEST(CausalText, Expiration) {
  const auto told = toldAt(2.5);
  EXPECT_THAT(told, Contains("The chest cavity shrinks because the breathing muscles let go."));
  EXPECT_THAT(told,
              Contains("The alveolar pressure rises because the lung shrinks faster than air goes out."));
  EXPECT_THAT(toldAt(4).front(), StartsWith("The breath turns to inspiration"));
}

TEST(CausalText, Pause) {
  const auto told = toldAt(1.9, {.pauseFrom = 0.7, .pauseFor = 5});
  EXPECT_THAT(told.front(),
              HasSubstr("the recoil of the lung is held by the intrapleural pressure below it"));
  EXPECT_THAT(told, Contains("No air flows because the alveolar pressure is atmospheric."));
  EXPECT_THAT(told,
              Contains("The lung stands because the transpulmonary pressure that stretches it stands."));
}

TEST(CausalText, OpenPneumothorax) {
  BreathingLung side;
  side.inputs.leak = wound(Pneumothorax::open, 1e-3);
  EXPECT_THAT(
      toldAt(20.5, {}, side).front(),
      StartsWith(
          "The lung no longer follows the chest wall because the wound lets air into the pleural space"));
  EXPECT_THAT(toldAt(20, {.depth = 0}, side).front(),
              HasSubstr("no intrapleural pressure below it holds the lung"));
}

TEST(CausalText, TensionPneumothorax) {
  BreathingLung side;
  side.inputs.leak = wound(Pneumothorax::tension, 1e-4);
  EXPECT_THAT(toldAt(60.5, {}, side), Contains(HasSubstr("above atmospheric and presses the lung together")));
  EXPECT_THAT(toldAt(1, {}, side), Contains(HasSubstr("stretches the lung less and less")));
}

TEST(CausalText, ClosedPneumothoraxAndItsDrain) {
  BreathingLung side;
  side.inputs.leak.kind = Pneumothorax::closed;
  admitGas(0.4 * kLitre, 101325, side.now);
  EXPECT_THAT(toldAt(12.5, {}, side).front(),
              StartsWith("The lung still follows the chest wall, but at a distance"));
  side.inputs.drain = {.isOn = true, .resistance = 1e8};
  const auto told = toldAt(4.5, {}, side);
  EXPECT_THAT(told.front(), HasSubstr("until the drain has taken it out"));
  EXPECT_THAT(told, Contains(HasSubstr("the drain takes gas out of the pleural space")));
  EXPECT_THAT(toldAt(400.5, {}, side).front(), "The breathing muscles pull harder.");  // the gas is gone
}

TEST(CausalText, EachSentenceSaysWhy) {
  for (const auto kind : {Pneumothorax::none, Pneumothorax::open, Pneumothorax::tension})
    for (const double area : {1e-3, 3e-6}) {
      BreathingLung side;
      side.inputs.leak = wound(kind, area);
      LungState before = side.now;
      int told = 0, whys = 0;
      side.breathe({.inspiration = 1.0 / 3, .pauseFrom = 14, .pauseFor = 2}, 20, 0.01, [&](double) {
        const CausalChain chain = causalChain(side.lung, side.inputs, before, side.now, 0.01);
        before = side.now;
        for (int k = 1; k < kQuantities; ++k) {
          const std::string text = sentence(chain, static_cast<Quantity>(k));
          ASSERT_EQ(text.back(), '.');
          ++told;
          if (text.find(" because ") != std::string::npos) ++whys;
        }
      });
      EXPECT_GT(whys, 0.98 * told);
    }
}

}  // namespace
}  // namespace pleura
