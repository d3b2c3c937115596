#include <algorithm>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/fields/field_types.h>
#include <pleura/fields/route_list.h>

namespace pleura {
namespace {

using testing::ElementsAreArray;

/// Against a vector, through empty, one and many and back, the same field in it more than once.
TEST(RouteList, KeepsTheOrderWhateverComesAndGoes) {
  std::mt19937 random(1);
  const auto below = [&](std::size_t count) { return random() % count; };
  std::vector<SFBool> fields(6);
  for (int round = 0; round < 200; ++round) {
    RouteList list;
    std::vector<Field*> expected;
    for (int i = 0; i < 60; ++i) {
      Field* const field = &fields[below(fields.size())];
      if (below(2) == 0) {
        list.push_back(field);
        expected.push_back(field);
      } else if (!expected.empty() && below(3) == 0) {
        list.pop_back();
        expected.pop_back();
      } else {
        list.remove(field);
        const auto last = std::find(expected.rbegin(), expected.rend(), field);
        if (last != expected.rend()) expected.erase(std::next(last).base());
      }
      ASSERT_THAT(list, ElementsAreArray(expected));
      ASSERT_EQ(list.size(), expected.size());
      ASSERT_EQ(list.empty(), expected.empty());
      ASSERT_EQ(list.contains(field), std::count(expected.begin(), expected.end(), field) > 0);
      if (expected.empty()) continue;
      ASSERT_EQ(list.back(), expected.back());
      ASSERT_EQ(list[expected.size() / 2], expected[expected.size() / 2]);
    }
  }
}

}  // namespace
}  // namespace pleura
