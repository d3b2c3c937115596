#include <array>
#include <thread>

#include <gtest/gtest.h>

#include <pleura/haptics/servo/exchange.h>

namespace pleura::haptics {
namespace {

TEST(Exchange, GivesTheLatest) {
  Exchange<int, 1> exchange;
  EXPECT_FALSE(exchange.take());
  for (const int value : {1, 2, 3}) {
    exchange.back() = value;
    exchange.publish();
  }
  ASSERT_TRUE(exchange.take());
  EXPECT_EQ(exchange.taken(), 3);
  EXPECT_FALSE(exchange.take());
  EXPECT_EQ(exchange.taken(), 3);
}

TEST(Exchange, KeepsTheLastOnesTaken) {
  Exchange<int, 2> exchange;
  for (int value = 1; value <= 50; ++value) {
    exchange.back() = value;
    exchange.publish();
    if (value % 3 != 0) continue;
    ASSERT_TRUE(exchange.take());
    EXPECT_EQ(exchange.taken(0), value);
    EXPECT_EQ(exchange.taken(1), value > 3 ? value - 3 : 0);
  }
}

TEST(Exchange, NeverHandsTheWriterWhatTheReaderKeeps) {
  // Values are written in two halves: a torn one would be seen, and so would one that changes while it is
  // kept.
  Exchange<std::array<int, 64>, 2> exchange;
  constexpr int kCount = 20000;
  std::thread writer([&] {
    for (int value = 1; value <= kCount; ++value) {
      exchange.back().fill(value);
      exchange.publish();
    }
  });
  int last = 0;
  while (last < kCount) {
    if (!exchange.take()) continue;
    for (const int age : {0, 1}) {
      const auto& kept = exchange.taken(age);
      for (const int value : kept) ASSERT_EQ(value, kept.front());
    }
    ASSERT_GT(exchange.taken(0).front(), last);
    ASSERT_EQ(exchange.taken(1).front(), last);
    last = exchange.taken(0).front();
  }
  writer.join();
}

}  // namespace
}  // namespace pleura::haptics
