#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/x3d/browser/tradeoff/advice.h>

namespace pleura {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kAny = std::numeric_limits<double>::infinity();

TierFigures tier(const char* method, int elements, double milliseconds, double millimetres) {
  TierFigures f;
  f.organ = "LUNG";
  f.method = method;
  f.elements = elements;
  f.median = 1e-3 * milliseconds;
  f.error.rms = 1e-3 * millimetres;
  return f;
}

class Advice : public ::testing::Test {
 protected:
  std::vector<TierFigures> figures{
      tier("smooth fill", 0, 0, 3),           tier("ChainMail", 0, 0.5, 2),
      tier("linear FEM", 60, 0.2, 0.8),       tier("Neo-Hookean FEM", 60, 8, 0.4),
      tier("Neo-Hookean FEM", 480, 40, 0.25), tier("reference", 3840, 900, 0.25)};
};

TEST_F(Advice, TheCheapestHoldsWhatIsAsked) {
  EXPECT_EQ(cheapest(figures, "LUNG", kAny, kAny)->method, "smooth fill");
  EXPECT_EQ(cheapest(figures, "LUNG", 2e-3, kAny)->method, "linear FEM");
  EXPECT_EQ(cheapest(figures, "LUNG", 0.5e-3, kAny)->elements, 60);
  EXPECT_EQ(cheapest(figures, "LUNG", 0.3e-3, kAny)->elements, 480);
  EXPECT_EQ(cheapest(figures, "LUNG", 0.5e-3, 1e-3), nullptr);
  EXPECT_EQ(cheapest(figures, "LUNG", 0.1e-3, kAny), nullptr) << "the reference is no choice";
  EXPECT_EQ(cheapest(figures, "DIAPHRAGM", kAny, kAny), nullptr);
}

TEST_F(Advice, WhatHasNotConvergedIsNoChoice) {
  figures[3].converged = false;
  EXPECT_EQ(cheapest(figures, "LUNG", 0.5e-3, kAny)->elements, 480);
}

TEST_F(Advice, SaysTheCheapestAndWhatNobodyCouldTellFromAPatient) {
  const std::string text = advice(figures);
  EXPECT_THAT(
      text, HasSubstr("LUNG: the cheapest is smooth fill (what the contacts cost anyway), off by 3 mm RMS"));
  EXPECT_THAT(text, HasSubstr("take Neo-Hookean FEM of 60 elements (8 ms), off by 0.4 mm RMS"));
}

TEST_F(Advice, SaysWhereNoTierIsNearEnough) {
  figures.resize(3);
  EXPECT_THAT(advice(figures), HasSubstr("No tier comes within 0.5 mm"));
}

TEST_F(Advice, SaysHowFarTheReferenceItselfIsToBeTrusted) {
  EXPECT_THAT(advice(figures),
              HasSubstr("The reference itself was moved by 0.25 mm when its 3840 elements were refined"));
  figures.resize(3);
  EXPECT_THAT(advice(figures), Not(HasSubstr("The reference itself")));
}

}  // namespace
}  // namespace pleura
