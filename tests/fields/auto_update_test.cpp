#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/fields/auto_update.h>
#include <pleura/fields/errors.h>
#include <pleura/fields/field_types.h>
#include <pleura/fields/typed_field.h>

namespace pleura {
namespace {

/// Writes down each value it takes.
class Log : public AutoUpdate<SFInt32> {
 public:
  std::vector<int> seen;

 private:
  void update() override {
    SFInt32::update();
    seen.push_back(value);
  }
};

TEST(AutoUpdate, TakesEveryEventUnread) {
  SFInt32 a, b;
  Log log;
  a.route(b);
  b.route(log);
  for (int i = 1; i < 4; ++i) a.setValue(i);
  EXPECT_EQ(log.seen, (std::vector{0, 1, 2, 3})) << "the first is the route's own";
}

TEST(AutoUpdate, RouteNoEventTellsItNothing) {
  SFInt32 a;
  Log log;
  a.routeNoEvent(log);
  EXPECT_TRUE(log.seen.empty());
}

class LogSum : public AutoUpdate<TypedField<SFInt32, Types<SFInt32, SFInt32>>> {
 public:
  std::vector<int> seen;

 private:
  void update() override {
    value = static_cast<SFInt32*>(routes_in[0])->getValue() + static_cast<SFInt32*>(routes_in[1])->getValue();
    seen.push_back(value);
  }
};

TEST(AutoUpdate, OfADiamondSeesOneWholeChange) {
  SFInt32 top, left, right;
  LogSum sum;
  top.route(left);
  top.route(right);
  left.routeNoEvent(sum);
  right.routeNoEvent(sum);
  top.setValue(5);
  top.setValue(6);
  EXPECT_EQ(sum.seen, (std::vector{10, 12})) << "each change once, never one side without the other";
}

TEST(AutoUpdate, OfARouteRefusedHearsNothing) {
  SFFloat wrong;
  Log log;
  EXPECT_THROW(wrong.route(log), RouteError);
  wrong.setValue(1);
  EXPECT_TRUE(log.seen.empty());
}

class Relay : public AutoUpdate<SFInt32> {
 public:
  explicit Relay(SFInt32& to) : to_(to) {}

 private:
  void update() override {
    SFInt32::update();
    to_.setValue(value + 1);
  }
  SFInt32& to_;
};

TEST(AutoUpdate, MaySetOthersAsItUpdates) {
  SFInt32 in, middle, out;
  Relay first(middle), second(out);
  Log log;
  in.route(first);
  middle.route(second);
  out.routeNoEvent(log);
  in.setValue(10);
  EXPECT_EQ(out.getValue(), 12);
  EXPECT_EQ(log.seen, std::vector{12});
}

TEST(AutoUpdate, ThatCausesItselfWithoutEndIsAnError) {
  SFInt32 loop, other;
  Relay relay(loop);
  Log log;
  EXPECT_THROW(loop.route(relay), FieldError);
  loop.unroute(relay);
  other.route(log);
  other.setValue(1);
  EXPECT_EQ(log.seen.back(), 1) << "and what follows works as before";
}

class Thrower : public AutoUpdate<SFInt32> {
  void update() override { throw std::domain_error("refused"); }
};

TEST(AutoUpdate, ThatThrowsSilencesNoOther) {
  SFInt32 a;
  Log before, after;
  Thrower thrower;
  a.routeNoEvent(before);
  a.routeNoEvent(thrower);
  a.routeNoEvent(after);
  EXPECT_THROW(a.setValue(1), std::domain_error);
  EXPECT_THROW(a.setValue(2), std::domain_error);
  EXPECT_EQ(before.seen, (std::vector{1, 2}));
  EXPECT_EQ(after.seen, (std::vector{1, 2}));
}

/// Destroys another that waits to be called.
class Killer : public AutoUpdate<SFInt32> {
 public:
  explicit Killer(std::unique_ptr<Log>& victim) : victim_(victim) {}

 private:
  void update() override { victim_.reset(); }
  std::unique_ptr<Log>& victim_;
};

TEST(AutoUpdate, DestroyedWhileItWaitsIsNotCalled) {
  SFInt32 a;
  auto victim = std::make_unique<Log>();
  Killer killer(victim);
  Log last;
  a.routeNoEvent(killer);
  a.routeNoEvent(*victim);
  a.routeNoEvent(last);
  a.setValue(1);
  EXPECT_EQ(victim, nullptr);
  EXPECT_EQ(last.seen, std::vector{1});
}

}  // namespace
}  // namespace pleura
