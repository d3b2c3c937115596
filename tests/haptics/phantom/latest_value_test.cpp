#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include <pleura/haptics/phantom/latest_value.h>

namespace pleura::haptics {
namespace {

TEST(LatestValue, GivesTheNewestOnce) {
  LatestValue<int> latest;
  int value = -1;
  EXPECT_FALSE(latest.take(value));
  EXPECT_EQ(value, -1);
  latest.put(1);
  latest.put(2);
  latest.put(3);
  EXPECT_TRUE(latest.take(value));
  EXPECT_EQ(value, 3);
  EXPECT_FALSE(latest.take(value));
  for (int i = 4; i < 20; ++i) {
    latest.put(i);
    EXPECT_TRUE(latest.take(value));
    EXPECT_EQ(value, i);
  }
}

TEST(LatestValue, IsNeverTornOrOlderThanWhatWasTaken) {
  constexpr int kPuts = 200'000;
  LatestValue<std::array<int, 16>> latest;
  std::thread writer([&] {
    for (int i = 1; i <= kPuts; ++i) {
      std::array<int, 16> value;
      value.fill(i);
      latest.put(value);
    }
  });
  std::array<int, 16> value{};
  int torn = 0, backwards = 0;
  for (int last = 0; last < kPuts;) {
    if (!latest.take(value)) continue;
    for (const int each : value) torn += each == value[0] ? 0 : 1;
    backwards += value[0] > last ? 0 : 1;
    last = value[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(backwards, 0);
}

}  // namespace
}  // namespace pleura::haptics
