#include <memory>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/fields/auto_update.h>
#include <pleura/fields/field_types.h>

namespace pleura {
namespace {

using AutoInt = AutoUpdate<SFInt32>;

/// Builds, sets, reads and destroys a chain that ends in an AutoUpdate.
void useAGraph(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  for (int round = 0; round < 20; ++round) {
    std::vector<SFInt32> chain(50);
    AutoInt last;
    for (std::size_t i = 1; i < chain.size(); ++i) chain[i - 1].route(chain[i]);
    chain.back().route(last);
    for (int i = 0; i < 50; ++i) {
      const int value = static_cast<int>(random() % 1000);
      chain.front().setValue(value);
      ASSERT_EQ(last.getValue(), value);
    }
  }
}

TEST(Threads, EachWithItsGraphDoNotDisturbEachOther) {
  std::thread one(useAGraph, 1), two(useAGraph, 2);
  one.join();
  two.join();
}

TEST(Threads, GraphMayMoveFromOneToAnother) {
  SFInt32 a, b;
  a.route(b);
  for (int i = 1; i < 20; ++i)
    std::thread([&] {
      a.setValue(i);
      EXPECT_EQ(b.getValue(), i);
    }).join();
  a.setValue(0);
  EXPECT_EQ(b.getValue(), 0);
}

}  // namespace
}  // namespace pleura
