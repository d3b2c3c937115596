#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/fields/counters.h>
#include <pleura/fields/field_types.h>
#include <pleura/fields/typed_field.h>

namespace pleura {
namespace {

std::uint64_t eventsOf(const auto& change) {
  const std::uint64_t before = fieldCounters().events;
  change();
  return fieldCounters().events - before;
}

TEST(Propagation, StampsGrowWithEverySet) {
  SFInt32 a;
  std::uint64_t last = a.getStamp();
  for (int i = 0; i < 1000; ++i) {
    a.setValue(0);
    EXPECT_GT(a.getStamp(), last);
    last = a.getStamp();
  }
}

/// H3D lost 96.5 % of these: its stamp was the wall clock.
TEST(Propagation, NoEventIsLostHoweverFastTheyFollow) {
  SFInt32 a, b;
  a.route(b);
  for (int i = 0; i < 100'000; ++i) {
    a.setValue(i);
    ASSERT_EQ(b.getValue(), i);
  }
}

TEST(Propagation, LastSenderWins) {
  SFInt32 a, b, c;
  a.route(c);
  b.route(c);
  b.setValue(2);
  a.setValue(1);
  EXPECT_EQ(c.getValue(), 1);
  a.setValue(3);
  b.setValue(4);
  EXPECT_EQ(c.getValue(), 4);
}

TEST(Propagation, DiamondIsMarkedOnceByTheFirstWay) {
  SFInt32 top, left, right, bottom;
  top.route(left);
  top.route(right);
  left.route(bottom);
  right.route(bottom);
  bottom.upToDate();
  EXPECT_EQ(eventsOf([&] { top.setValue(1); }), 3U);
  left.unroute(bottom);
  EXPECT_TRUE(bottom.isUpToDate()) << "what is cancelled is what came from the left";
}

TEST(Propagation, CycleEnds) {
  std::vector<SFInt32> ring(5);
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i].route(ring[(i + 1) % ring.size()]);
  for (const int value : {3, 4}) {
    EXPECT_LE(eventsOf([&] { ring[2].setValue(value); }), ring.size() - 1);
    for (SFInt32& field : ring) EXPECT_EQ(field.getValue(), value);
  }
}

TEST(Propagation, OfWhatNobodyHasReadSinceCostsNothing) {
  SFInt32 hub;
  std::vector<SFInt32> rim(100), behind(100);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    hub.route(rim[i]);
    rim[i].route(behind[i]);
  }
  hub.setValue(1);
  for (SFInt32& field : behind) field.upToDate();
  EXPECT_EQ(eventsOf([&] { hub.setValue(2); }), 200U);
  EXPECT_EQ(eventsOf([&] { hub.setValue(3); }), 0U);
  EXPECT_EQ(behind[7].getValue(), 3);
  EXPECT_GT(eventsOf([&] { hub.setValue(4); }), 0U);
  EXPECT_EQ(behind[7].getValue(), 4);
  EXPECT_EQ(behind[8].getValue(), 4);
}

/// `bottom` is reached by way of `left`, which is out of date already and passed over: the way over `right`,
/// walked after it, comes too late all the same.
TEST(Propagation, WhatIsPassedOverCountsAsReached) {
  SFInt32 top, left, right, bottom;
  top.route(left);
  top.route(right);
  left.route(bottom);
  right.route(bottom);
  left.setValue(1);
  top.setValue(2);
  left.unroute(bottom);
  EXPECT_TRUE(bottom.isUpToDate());
}

TEST(Propagation, WhatIsPassedOverDeeperCountsAsReached) {
  SFInt32 top, right;
  std::vector<SFInt32> left(6);
  top.route(left[0]);
  for (std::size_t i = 1; i < left.size(); ++i) left[i - 1].route(left[i]);
  top.route(right);
  right.route(left[5]);
  right.route(left[3]);
  left[0].setValue(1);
  top.setValue(2);
  left[4].unroute(left[5]);
  left[2].unroute(left[3]);
  EXPECT_TRUE(left[5].isUpToDate());
  EXPECT_TRUE(left[3].isUpToDate());
}

TEST(Propagation, ValueSetOnTheWayDropsWhatIsPending) {
  SFInt32 a, b, c;
  a.route(b);
  b.route(c);
  a.setValue(1);
  b.setValue(2);
  EXPECT_TRUE(b.isUpToDate());
  EXPECT_EQ(c.getValue(), 2);
  a.setValue(3);
  EXPECT_EQ(c.getValue(), 3);
}

TEST(Propagation, TouchSendsTheValueThatIs) {
  SFInt32 a, b;
  a.setValue(5);
  a.routeNoEvent(b);
  a.touch();
  EXPECT_EQ(b.getValue(), 5);
}

/// Sets a field upstream of itself while it is evaluated, once.
class Feedback : public TypedField<SFInt32, Types<SFInt32>> {
 public:
  explicit Feedback(SFInt32& upstream) : upstream_(upstream) {}

 private:
  void update() override {
    value = static_cast<SFInt32*>(routes_in[0])->getValue();
    if (value < 3) upstream_.setValue(value + 1);
  }
  SFInt32& upstream_;
};

TEST(Propagation, EventOfOnesOwnEvaluationIsKept) {
  SFInt32 source, middle;
  Feedback feedback(source);
  source.route(middle);
  middle.route(feedback);
  source.setValue(1);
  EXPECT_EQ(feedback.getValue(), 1);
  EXPECT_EQ(feedback.getValue(), 2);
  EXPECT_EQ(feedback.getValue(), 3);
  EXPECT_TRUE(feedback.isUpToDate());
}

/// A million fields on the way would overflow the stack if anything here called itself.
TEST(Propagation, ChainOfAMillionIsSetReadAndDestroyed) {
  constexpr int kLength = 1'000'000;
  std::vector<std::unique_ptr<SFInt32>> chain;
  chain.reserve(kLength);
  chain.push_back(std::make_unique<SFInt32>());
  for (int i = 1; i < kLength; ++i) {
    chain.push_back(std::make_unique<SFInt32>());
    chain[chain.size() - 2]->routeNoEvent(*chain.back());
  }
  chain.front()->setValue(17);
  EXPECT_EQ(chain.back()->getValue(), 17);
  chain.front()->setValue(18);
  EXPECT_EQ(chain[kLength / 2]->getValue(), 18);
  EXPECT_EQ(chain.back()->getValue(), 18);
  chain.front()->setValue(19);
}

}  // namespace
}  // namespace pleura
