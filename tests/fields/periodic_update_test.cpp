#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/fields/field_types.h>
#include <pleura/fields/periodic_update.h>

namespace pleura {
namespace {

using testing::ElementsAre;

class Tick : public PeriodicUpdate<SFInt32> {
 public:
  std::vector<int>& seen;
  explicit Tick(std::vector<int>& log) : seen(log) {}

 private:
  void update() override {
    SFInt32::update();
    seen.push_back(value);
  }
};

TEST(PeriodicUpdate, EvaluatesOnceATickWhatHasChanged) {
  std::vector<int> seen;
  SFInt32 a;
  Tick tick(seen);
  a.routeNoEvent(tick);
  a.setValue(1);
  a.setValue(2);
  EXPECT_TRUE(seen.empty());
  PeriodicFields::upToDate();
  PeriodicFields::upToDate();
  EXPECT_THAT(seen, ElementsAre(2));
  a.setValue(3);
  PeriodicFields::upToDate();
  EXPECT_THAT(seen, ElementsAre(2, 3));
}

TEST(PeriodicUpdate, GoesInTheOrderOfMaking) {
  std::vector<int> seen;
  SFInt32 a, b;
  Tick first(seen), second(seen);
  b.routeNoEvent(second);
  a.routeNoEvent(first);
  b.setValue(2);
  a.setValue(1);
  PeriodicFields::upToDate();
  EXPECT_THAT(seen, ElementsAre(1, 2));
}

TEST(PeriodicUpdate, DestroyedIsNotEvaluated) {
  std::vector<int> seen;
  SFInt32 a;
  {
    Tick tick(seen);
    a.route(tick);
  }
  PeriodicFields::upToDate();
  EXPECT_TRUE(seen.empty());
}

class Last : public PeriodicUpdate<SFInt32> {
 public:
  explicit Last(std::unique_ptr<Tick>& victim) : victim_(victim) {}

 private:
  void update() override { victim_.reset(); }
  std::unique_ptr<Tick>& victim_;
};

TEST(PeriodicUpdate, DestroyedByOneBeforeItSkipsNoOther) {
  std::vector<int> seen;
  SFInt32 a;
  auto early = std::make_unique<Tick>(seen);
  Last killer(early);
  Tick after(seen);
  a.routeNoEvent(killer);
  a.routeNoEvent(after);
  a.setValue(1);
  PeriodicFields::upToDate();
  EXPECT_THAT(seen, ElementsAre(1));
}

}  // namespace
}  // namespace pleura
