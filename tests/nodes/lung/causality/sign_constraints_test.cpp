#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/nodes/lung/causality/sign_constraints.h>

namespace pleura {
namespace {

const SignSet kFalls = Sign::falls, kStands = Sign::stands, kRises = Sign::rises;

TEST(NarrowSum, FollowsWhatIsSure) {
  SignSet a = kFalls, b = kFalls | kStands, c;
  EXPECT_TRUE(narrowSum(a, b, c));
  EXPECT_EQ(c, kFalls);
  EXPECT_FALSE(narrowSum(a, b, c));
}

TEST(NarrowSum, LeavesOpenWhatOpposites) {
  SignSet a = kFalls, b = kRises, c;
  EXPECT_FALSE(narrowSum(a, b, c));
  EXPECT_EQ(c, SignSet());
}

TEST(NarrowSum, InfersBackwards) {
  SignSet a = kFalls, b, c = kRises | kStands;
  narrowSum(a, b, c);
  EXPECT_EQ(b, kRises);
}

TEST(NarrowSum, ContradictionsRunEmpty) {
  SignSet a = kFalls, b = kStands, c = kRises;
  narrowSum(a, b, c);
  EXPECT_TRUE(a.isEmpty() && b.isEmpty() && c.isEmpty());
}

TEST(NarrowAlikeAndContrary, GoBothWays) {
  SignSet a, b = kRises;
  EXPECT_TRUE(narrowAlike(a, b));
  EXPECT_EQ(a, kRises);
  a = SignSet();
  EXPECT_TRUE(narrowContrary(a, b));
  EXPECT_EQ(a, kFalls);
  b = SignSet();
  EXPECT_TRUE(narrowContrary(a, b));
  EXPECT_EQ(b, kRises);
}

// Else propagation would never end.
TEST(SignConstraints, NarrowOnlyOnce) {
  const SignSet sets[] = {kFalls & kRises,  kFalls,          kStands,  kRises,
                          kFalls | kStands, kFalls | kRises, SignSet()};
  for (const SignSet x : sets)
    for (const SignSet y : sets) {
      SignSet a = x, b = y;
      narrowAlike(a, b);
      EXPECT_FALSE(narrowAlike(a, b));
      a = x, b = y;
      narrowContrary(a, b);
      EXPECT_FALSE(narrowContrary(a, b));
      for (const SignSet z : sets) {
        a = x, b = y;
        SignSet c = z;
        narrowSum(a, b, c);
        EXPECT_FALSE(narrowSum(a, b, c));
        a = x, b = y, c = z;
        narrowProduct(a, b, c);
        EXPECT_FALSE(narrowProduct(a, b, c));
      }
    }
}

// Numbers a + b = c with any signs: what is left always has theirs.
TEST(NarrowSum, NeverRemovesWhatNumbersDo) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> number(-2, 2), hidden(0, 1);
  for (int k = 0; k < 2000; ++k) {
    const int a = number(random), b = number(random);
    SignSet sa = hidden(random) ? SignSet() : SignSet(signOf(a));
    SignSet sb = hidden(random) ? SignSet() : SignSet(signOf(b));
    SignSet sc = hidden(random) ? SignSet() : SignSet(signOf(a + b));
    narrowSum(sa, sb, sc);
    EXPECT_TRUE(sa.contains(signOf(a)) && sb.contains(signOf(b)) && sc.contains(signOf(a + b)));
  }
}

TEST(NarrowProduct, TellsNothingOfASmallFactorWhenTheOthersStand) {
  SignSet a, b = kStands, c = kStands;
  EXPECT_FALSE(narrowProduct(a, b, c));
  b = kRises;
  narrowProduct(a, b, c);
  EXPECT_EQ(a, kFalls);
  a = SignSet(), b = kFalls, c = kRises;
  narrowProduct(a, b, c);
  EXPECT_EQ(a, kRises);
}

}  // namespace
}  // namespace pleura
