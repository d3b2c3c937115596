#include <gtest/gtest.h>

#include <pleura/fields/range_text.h>

namespace pleura {
namespace {

FieldDeclaration within(double least, double most) {
  FieldDeclaration declaration;
  declaration.minimum = least;
  declaration.maximum = most;
  return declaration;
}

TEST(RangeText, SaysWhatPeopleWouldSay) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  constexpr double kAboveZero = std::numeric_limits<float>::min();
  EXPECT_EQ(rangeText({}), "");
  EXPECT_EQ(rangeText(within(0, 0.49995)), "0 to 0.49995");
  EXPECT_EQ(rangeText(within(-1e9, 1e9)), "-1e+09 to 1e+09");
  EXPECT_EQ(rangeText(within(0, kAny)), "at least 0");
  EXPECT_EQ(rangeText(within(-kAny, 8)), "at most 8");
  EXPECT_EQ(rangeText(within(kAboveZero, kAny)), "above 0");
  EXPECT_EQ(rangeText(within(kAboveZero, 1e12)), "above 0, at most 1e+12");
}

}  // namespace
}  // namespace pleura
