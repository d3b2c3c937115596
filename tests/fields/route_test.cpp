#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/fields/errors.h>
#include <pleura/fields/field_types.h>

namespace pleura {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Route, CarriesTheValueByReferenceOrPointer) {
  SFFloat a, b, c;
  a.route(b);
  b.route(&c);
  a.setValue(4);
  EXPECT_EQ(c.getValue(), 4);
}

TEST(Route, SendsAnEventAtOnceUnlessToldNot) {
  SFFloat a, sent, silent;
  a.setValue(3);
  a.route(sent);
  a.routeNoEvent(silent);
  EXPECT_FALSE(sent.isUpToDate());
  EXPECT_TRUE(silent.isUpToDate());
  EXPECT_EQ(sent.getValue(), 3);
  EXPECT_EQ(silent.getValue(), 0);
  a.setValue(5);
  EXPECT_EQ(silent.getValue(), 5);
}

TEST(Route, FirstEventReachesWhatIsBehindTheTarget) {
  SFFloat a, b, c;
  b.route(c);
  EXPECT_EQ(c.getValue(), 0);
  a.setValue(8);
  a.route(b);
  EXPECT_EQ(c.getValue(), 8);
}

TEST(Route, FirstEventReachesNoOtherTarget) {
  SFFloat a, old, fresh;
  a.route(old);
  old.upToDate();
  a.route(fresh);
  EXPECT_TRUE(old.isUpToDate());
  EXPECT_FALSE(fresh.isUpToDate());
}

TEST(Route, FromAFieldThatIsOutOfDateCarriesItsNewValue) {
  SFFloat source, middle, late;
  source.route(middle);
  source.setValue(6);
  middle.route(late);
  EXPECT_EQ(late.getValue(), 6);
  EXPECT_EQ(middle.getValue(), 6);
}

TEST(Route, ListsKeepTheOrderOfMaking) {
  SFInt32 a, b, c;
  b.route(c);
  a.route(c);
  a.route(b);
  EXPECT_THAT(c.getRoutesIn(), ElementsAre(&b, &a));
  EXPECT_THAT(a.getRoutesOut(), ElementsAre(&c, &b));
  EXPECT_TRUE(a.routesTo(c));
  EXPECT_TRUE(a.routesTo(&b));
  EXPECT_FALSE(c.routesTo(a));
}

TEST(Route, DuplicateIsIgnoredAndSendsNoEvent) {
  SFInt32 a, b;
  a.route(b);
  b.upToDate();
  a.route(b);
  a.routeNoEvent(b);
  EXPECT_THAT(b.getRoutesIn(), ElementsAre(&a));
  EXPECT_TRUE(b.isUpToDate());
}

TEST(Route, OfAnotherTypeIsRefusedAndLeavesNothing) {
  SFFloat metres;
  SFDouble wide;
  SFTime time;
  MFFloat many;
  EXPECT_THROW(metres.route(wide), RouteError);
  EXPECT_THROW(wide.routeNoEvent(time), RouteError) << "both hold a double";
  EXPECT_THROW(metres.route(many), RouteError);
  for (const Field* field : std::initializer_list<Field*>{&metres, &wide, &time, &many}) {
    EXPECT_THAT(field->getRoutesIn(), IsEmpty());
    EXPECT_THAT(field->getRoutesOut(), IsEmpty());
    EXPECT_TRUE(field->isUpToDate());
  }
}

TEST(Route, RefusalSaysWhatIsExpected) {
  SFFloat from;
  SFVec3f to;
  try {
    from.route(to);
    FAIL() << "no error";
  } catch (const RouteError& error) {
    EXPECT_THAT(error.what(), HasSubstr("SFFloat TO SFVec3f"));
    EXPECT_THAT(error.what(), HasSubstr("SFVec3f is expected"));
  }
}

TEST(Route, RefusedAmongOthersDisturbsNone) {
  SFFloat a, b;
  SFBool wrong;
  a.route(b);
  a.setValue(2);
  EXPECT_THROW(a.route(wrong), RouteError);
  EXPECT_EQ(b.getValue(), 2);
  a.setValue(3);
  EXPECT_EQ(b.getValue(), 3);
}

TEST(Unroute, CancelsWhatIsPendingAndKeepsTheValue) {
  SFFloat a, b, c;
  b.route(c);
  a.route(b);
  a.setValue(1);
  EXPECT_EQ(c.getValue(), 1);
  a.setValue(2);
  a.unroute(b);
  EXPECT_TRUE(b.isUpToDate());
  EXPECT_EQ(b.getValue(), 1);
  EXPECT_EQ(c.getValue(), 1);
  a.setValue(3);
  EXPECT_EQ(c.getValue(), 1);
}

TEST(Unroute, KeepsWhatIsPendingFromAnother) {
  SFFloat a, b, c;
  a.route(c);
  b.route(c);
  b.setValue(7);
  a.unroute(&c);
  EXPECT_EQ(c.getValue(), 7);
}

TEST(Unroute, OfNoRouteDoesNothing) {
  SFFloat a, b;
  a.unroute(b);
  b.route(a);
  a.unroute(b);
  EXPECT_TRUE(b.routesTo(a));
}

TEST(Unroute, ThenRoutingAgainWorks) {
  SFFloat a, b;
  a.route(b);
  a.setValue(1);
  a.unroute(b);
  a.route(b);
  EXPECT_EQ(b.getValue(), 1);
  EXPECT_THAT(b.getRoutesIn(), ElementsAre(&a));
}

TEST(DestroyedField, TakesItsRoutesWithIt) {
  SFFloat before, after;
  {
    SFFloat between;
    before.route(between);
    between.route(after);
    before.setValue(9);
  }
  EXPECT_THAT(before.getRoutesOut(), IsEmpty());
  EXPECT_THAT(after.getRoutesIn(), IsEmpty());
  EXPECT_EQ(after.getValue(), 0);
  before.setValue(10);
}

TEST(DestroyedField, MayRouteToItself) {
  auto self = std::make_unique<SFFloat>();
  self->route(*self);
  self->setValue(2);
  EXPECT_EQ(self->getValue(), 2);
  self.reset();
}

/// Quadratic removal would take minutes here.
TEST(DestroyedField, HubOfManyRoutesGoesAtOnce) {
  std::vector<SFFloat> targets(200'000);
  auto hub = std::make_unique<SFFloat>();
  for (SFFloat& target : targets) hub->route(target);
  hub.reset();
  EXPECT_THAT(targets.front().getRoutesIn(), IsEmpty());
  EXPECT_THAT(targets.back().getRoutesIn(), IsEmpty());
}

}  // namespace
}  // namespace pleura
