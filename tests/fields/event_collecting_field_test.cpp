#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/fields/auto_update.h>
#include <pleura/fields/event_collecting_field.h>
#include <pleura/fields/field_types.h>
#include <pleura/fields/typed_field.h>

namespace pleura {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Keeps the senders of its last evaluation.
class Collector : public EventCollectingField<TypedField<SFInt32, AnyNumber<SFInt32>>> {
 public:
  std::vector<const Field*> senders;
  std::vector<std::uint64_t> stamps;
  SFInt32* sets = nullptr;

  bool heard(const Field& field) const { return hasCausedEvent(field); }

 private:
  void update() override {
    senders.clear();
    stamps.clear();
    for (const Event& cause : getCausingEvents()) {
      senders.push_back(cause.sender);
      stamps.push_back(cause.stamp);
    }
    if (sets != nullptr) std::exchange(sets, nullptr)->setValue(1);
  }
};

class EventCollectingFieldTest : public testing::Test {
 protected:
  SFInt32 a_, b_, c_;
  Collector collector_;

  EventCollectingFieldTest() {
    for (SFInt32* input : {&a_, &b_, &c_}) input->routeNoEvent(collector_);
  }
  std::vector<const Field*> senders() {
    collector_.senders.clear();
    collector_.upToDate();
    return collector_.senders;
  }
};

TEST_F(EventCollectingFieldTest, RemembersAllThatHaveSentInOrder) {
  c_.setValue(1);
  a_.setValue(1);
  EXPECT_TRUE(collector_.heard(a_));
  EXPECT_FALSE(collector_.heard(b_));
  EXPECT_THAT(senders(), ElementsAre(&c_, &a_));
  EXPECT_FALSE(collector_.heard(a_));
}

TEST_F(EventCollectingFieldTest, StartsAnewAfterEachEvaluation) {
  a_.setValue(1);
  EXPECT_THAT(senders(), ElementsAre(&a_));
  EXPECT_THAT(senders(), IsEmpty());
  b_.setValue(1);
  EXPECT_THAT(senders(), ElementsAre(&b_));
}

TEST_F(EventCollectingFieldTest, EachSenderStandsOnceWithItsNewestStamp) {
  a_.setValue(1);
  b_.setValue(1);
  a_.setValue(2);
  EXPECT_THAT(senders(), ElementsAre(&a_, &b_));
  EXPECT_THAT(collector_.stamps, ElementsAre(a_.getStamp(), b_.getStamp()));
  EXPECT_GT(collector_.stamps[0], collector_.stamps[1]);
}

/// A plain field hears the first way of a diamond only.
TEST_F(EventCollectingFieldTest, HearsEveryWayOfADiamond) {
  SFInt32 top;
  top.routeNoEvent(a_);
  top.routeNoEvent(b_);
  for (int i = 0; i < 3; ++i) {
    top.setValue(i);
    top.setValue(i);
    EXPECT_THAT(senders(), ElementsAre(&a_, &b_));
  }
}

TEST_F(EventCollectingFieldTest, ForgetsTheSenderWhoseRouteEnds) {
  a_.setValue(1);
  b_.setValue(1);
  a_.unroute(collector_);
  EXPECT_THAT(senders(), ElementsAre(&b_));
}

TEST_F(EventCollectingFieldTest, ForgetsTheSenderThatIsDestroyed) {
  auto gone = std::make_unique<SFInt32>();
  gone->route(collector_);
  b_.setValue(1);
  gone.reset();
  EXPECT_THAT(senders(), ElementsAre(&b_));
}

TEST_F(EventCollectingFieldTest, SettingItDropsWhatWasPending) {
  a_.setValue(1);
  collector_.setValue(4);
  EXPECT_THAT(senders(), IsEmpty());
  b_.setValue(1);
  EXPECT_THAT(senders(), ElementsAre(&b_));
}

TEST_F(EventCollectingFieldTest, EventDuringItsEvaluationIsKeptForTheNext) {
  collector_.sets = &b_;
  a_.setValue(1);
  EXPECT_THAT(senders(), ElementsAre(&a_));
  EXPECT_FALSE(collector_.isUpToDate());
  EXPECT_THAT(senders(), ElementsAre(&b_));
  EXPECT_TRUE(collector_.isUpToDate());
}

TEST(EventCollectingField, IsAlsoAnAutoUpdate) {
  class Both : public AutoUpdate<EventCollectingField<SFInt32>> {
   public:
    std::vector<std::size_t> counts;

   private:
    void update() override { counts.push_back(getCausingEvents().size()); }
  };
  SFInt32 top, a, b;
  Both both;
  top.route(a);
  top.route(b);
  a.routeNoEvent(both);
  b.routeNoEvent(both);
  top.setValue(1);
  a.setValue(2);
  EXPECT_THAT(both.counts, ElementsAre(2U, 1U));
}

}  // namespace
}  // namespace pleura
