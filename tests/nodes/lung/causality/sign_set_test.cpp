#include <gtest/gtest.h>

#include <pleura/nodes/lung/causality/sign_set.h>

namespace pleura {
namespace {

TEST(SignSet, AnySignUntilSomethingIsKnown) {
  const SignSet any;
  for (const Sign sign : {Sign::falls, Sign::stands, Sign::rises}) EXPECT_TRUE(any.contains(sign));
  EXPECT_FALSE(any.isOne());
  EXPECT_TRUE(SignSet(Sign::falls).isOne());
  EXPECT_FALSE(SignSet(Sign::falls).contains(Sign::rises));
}

TEST(SignSet, MeetsAndJoins) {
  const SignSet falls = Sign::falls, stands = Sign::stands;
  EXPECT_TRUE((falls & stands).isEmpty());
  EXPECT_EQ((falls | stands) & falls, falls);
  EXPECT_FALSE((falls | stands).contains(Sign::rises));
}

TEST(SignSet, IsSureOnlyAwayFromTheEdgeOfTheDeadBand) {
  EXPECT_EQ(SignSet::of(2.1, 1), SignSet(Sign::rises));
  EXPECT_EQ(SignSet::of(-2.1, 1), SignSet(Sign::falls));
  EXPECT_EQ(SignSet::of(0.4, 1), SignSet(Sign::stands));
  EXPECT_EQ(SignSet::of(1.5, 1), SignSet(Sign::rises) | SignSet(Sign::stands));
  EXPECT_EQ(SignSet::of(-0.7, 1), SignSet(Sign::falls) | SignSet(Sign::stands));
  EXPECT_EQ(SignSet::of(0, 0), SignSet(Sign::stands));
}

TEST(Sign, OfANumber) {
  EXPECT_EQ(signOf(0.5, 1), Sign::stands);
  EXPECT_EQ(signOf(1.5, 1), Sign::rises);
  EXPECT_EQ(signOf(-1.5, 1), Sign::falls);
  EXPECT_EQ(opposite(Sign::falls), Sign::rises);
  EXPECT_EQ(opposite(Sign::stands), Sign::stands);
}

}  // namespace
}  // namespace pleura
