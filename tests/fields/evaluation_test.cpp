#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/fields/counters.h>
#include <pleura/fields/field_types.h>
#include <pleura/fields/typed_field.h>

namespace pleura {
namespace {

std::uint64_t updatesOf(const auto& change) {
  const std::uint64_t before = fieldCounters().updates;
  change();
  return fieldCounters().updates - before;
}

class Sum : public TypedField<SFInt32, AnyNumber<SFInt32>> {
  void update() override {
    int sum = 0;
    for (Field* input : routes_in) sum += static_cast<SFInt32*>(input)->getValue();
    value = sum % 1009;
  }
};

/// Reads its first input only.
class First : public TypedField<SFInt32, AnyNumber<SFInt32>> {
  void update() override { value = static_cast<SFInt32*>(routes_in[0])->getValue(); }
};

TEST(Evaluation, FieldThatNobodyReadsNeverComputes) {
  SFInt32 a, b, c;
  a.route(b);
  b.route(c);
  EXPECT_EQ(updatesOf([&] {
              for (int i = 0; i < 10; ++i) a.setValue(i);
            }),
            0U);
  EXPECT_EQ(updatesOf([&] { c.getValue(); }), 2U);
  EXPECT_EQ(updatesOf([&] { c.getValue(); }), 0U);
}

TEST(Evaluation, ReadingHalfWayEvaluatesHalfTheChain) {
  std::vector<SFInt32> chain(11);
  for (std::size_t i = 1; i < chain.size(); ++i) chain[i - 1].route(chain[i]);
  chain[0].setValue(5);
  EXPECT_EQ(updatesOf([&] { chain[5].getValue(); }), 5U);
  EXPECT_EQ(updatesOf([&] { chain[10].getValue(); }), 5U);
  EXPECT_EQ(chain[10].getValue(), 5);
}

TEST(Evaluation, InputThatIsNotReadIsNotEvaluated) {
  SFInt32 source, left, right;
  First first;
  source.route(left);
  source.route(right);
  left.route(first);
  right.route(first);
  source.setValue(4);
  EXPECT_EQ(updatesOf([&] { EXPECT_EQ(first.getValue(), 4); }), 2U);
  EXPECT_FALSE(right.isUpToDate());
}

/// D diamonds on end: 2 fields a side and one to join them, each evaluated once.
TEST(Evaluation, DiamondsOfDepthDEvaluateEachFieldOnce) {
  constexpr std::size_t kDepth = 20;
  std::vector<SFInt32> sides(2 * kDepth);
  std::vector<Sum> joints(kDepth + 1);
  SFInt32 top;
  top.route(joints[0]);
  for (std::size_t i = 0; i < kDepth; ++i)
    for (const std::size_t side : {2 * i, 2 * i + 1}) {
      joints[i].route(sides[side]);
      sides[side].route(joints[i + 1]);
    }
  joints.back().upToDate();
  for (const int start : {1, 2}) {
    const std::uint64_t events = fieldCounters().events;
    top.setValue(start);
    EXPECT_EQ(fieldCounters().events - events, 3 * kDepth + 1);
    int expected = start;
    for (std::size_t i = 0; i < kDepth; ++i) expected = 2 * expected % 1009;
    EXPECT_EQ(updatesOf([&] { EXPECT_EQ(joints.back().getValue(), expected); }), 3 * kDepth + 1);
  }
}

TEST(Evaluation, CycleOfSumsEndsAndReadsWhatWasBefore) {
  SFInt32 seed;
  Sum a, b;
  seed.route(a);
  a.route(b);
  b.route(a);
  seed.setValue(1);
  const int before = b.getValue();
  EXPECT_TRUE(a.isUpToDate());
  seed.setValue(1);
  EXPECT_EQ(b.getValue(), before + 1) << "a = seed + b of before, b = a";
}

/// Two ladders of sums: more than 2^1000 ways to the end, and deeper than update() may call itself.
TEST(Evaluation, DeepLadderEvaluatesEachFieldOnce) {
  constexpr std::size_t kDepth = 1000;
  std::vector<Sum> ladder(2 * kDepth);
  SFInt32 top;
  top.route(ladder[0]);
  top.route(ladder[1]);
  for (std::size_t i = 2; i < ladder.size(); ++i)
    for (const std::size_t above : {i / 2 * 2 - 2, i / 2 * 2 - 1}) ladder[above].routeNoEvent(ladder[i]);
  top.setValue(1);
  int expected = 1;
  for (std::size_t i = 1; i < kDepth; ++i) expected = 2 * expected % 1009;
  EXPECT_EQ(updatesOf([&] { EXPECT_EQ(ladder.back().getValue(), expected); }), 2 * kDepth - 1);
}

TEST(Evaluation, DeepCycleEnds) {
  std::vector<Sum> ring(1000);
  SFInt32 seed;
  seed.route(ring[0]);
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i].routeNoEvent(ring[(i + 1) % ring.size()]);
  seed.setValue(2);
  EXPECT_EQ(ring.back().getValue(), 2);
  seed.setValue(3);
  EXPECT_EQ(ring.back().getValue(), 5);
}

/// Throws when its input is negative.
class Root : public TypedField<SFInt32, Types<SFInt32>> {
  void update() override {
    const int square = static_cast<SFInt32*>(routes_in[0])->getValue();
    if (square < 0) throw std::domain_error("negative");
    value = square;
  }
};

TEST(Evaluation, ThatThrowsLeavesTheFieldPendingAndTheGraphWhole) {
  SFInt32 source;
  std::vector<Root> chain(400);
  source.routeNoEvent(chain[0]);
  for (std::size_t i = 1; i < chain.size(); ++i) chain[i - 1].routeNoEvent(chain[i]);
  source.setValue(-1);
  EXPECT_THROW(chain.back().getValue(), std::domain_error);
  EXPECT_FALSE(chain[0].isUpToDate());
  EXPECT_THROW(chain.back().getValue(), std::domain_error) << "it is no cycle";
  source.setValue(4);
  EXPECT_EQ(chain.back().getValue(), 4);
}

/// What reads first and compares then sees every change.
TEST(Evaluation, StampSaysThatTheValueMayHaveChanged) {
  SFInt32 a, b, c;
  a.route(b);
  b.route(c);
  for (int i = 0; i < 3; ++i) {
    c.getValue();
    const std::uint64_t kept = c.getStamp();
    c.getValue();
    EXPECT_EQ(c.getStamp(), kept);
    a.setValue(i);
    a.setValue(i + 1);
    c.getValue();
    EXPECT_GT(c.getStamp(), kept);
  }
}

}  // namespace
}  // namespace pleura
