#include <thread>

#include <gtest/gtest.h>

#include <pleura/fields/counters.h>
#include <pleura/fields/field_types.h>

namespace pleura {
namespace {

TEST(Counters, MakeLazinessVisible) {
  SFInt32 a, b, c;
  a.route(b);
  b.route(c);
  const FieldCounters before = fieldCounters();
  a.setValue(1);
  EXPECT_EQ(fieldCounters().updates, before.updates);
  EXPECT_EQ(fieldCounters().events, before.events + 2);
  c.getValue();
  EXPECT_EQ(fieldCounters().updates, before.updates + 2);
  c.getValue();
  EXPECT_EQ(fieldCounters().updates, before.updates + 2);
  for (int i = 0; i < 10; ++i) a.setValue(i);
  EXPECT_EQ(fieldCounters().events, before.events + 4)
      << "the first of ten marks, the others find all marked";
}

TEST(Counters, AreOfTheThread) {
  const FieldCounters before = fieldCounters();
  std::thread([] {
    const FieldCounters start = fieldCounters();
    SFInt32 a, b;
    a.route(b);
    b.getValue();
    EXPECT_EQ(fieldCounters().updates, start.updates + 1);
  }).join();
  EXPECT_EQ(fieldCounters().updates, before.updates);
  EXPECT_EQ(fieldCounters().events, before.events);
}

}  // namespace
}  // namespace pleura
