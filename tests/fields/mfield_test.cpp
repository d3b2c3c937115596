#include <numeric>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/fields/field_types.h>

namespace pleura {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Whether `change` sent an event.
bool sends(MFInt32& from, const auto& change) {
  MFInt32 to;
  from.routeNoEvent(to);
  change();
  return !to.isUpToDate();
}

class MFieldTest : public testing::Test {
 protected:
  MFInt32 field_;
  MFieldTest() { field_.setValue({3, 1, 4, 1}); }
};

TEST_F(MFieldTest, StartsEmpty) {
  MFVec3f fresh;
  EXPECT_TRUE(fresh.empty());
  EXPECT_EQ(fresh.size(), 0U);
  EXPECT_EQ(fresh.getValueAsString(), "");
}

TEST_F(MFieldTest, EveryChangeSendsAnEvent) {
  std::vector<int> other = {8};
  EXPECT_TRUE(sends(field_, [&] { field_.setValue(field_.getValue()); }));
  EXPECT_TRUE(sends(field_, [&] { field_.setValue(2, 5); }));
  EXPECT_THAT(field_.getValue(), ElementsAre(3, 1, 5, 1));
  EXPECT_TRUE(sends(field_, [&] { field_.push_back(9); }));
  EXPECT_THAT(field_.getValue(), ElementsAre(3, 1, 5, 1, 9));
  EXPECT_TRUE(sends(field_, [&] { field_.erase(1); }));
  EXPECT_THAT(field_.getValue(), ElementsAre(3, 5, 1, 9));
  EXPECT_TRUE(sends(field_, [&] { field_.erase(77); }));
  EXPECT_THAT(field_.getValue(), ElementsAre(3, 5, 1, 9));
  EXPECT_TRUE(sends(field_, [&] { field_.resize(2); }));
  EXPECT_THAT(field_.getValue(), ElementsAre(3, 5));
  EXPECT_TRUE(sends(field_, [&] { field_.swap(other); }));
  EXPECT_THAT(field_.getValue(), ElementsAre(8));
  EXPECT_THAT(other, ElementsAre(3, 5));
  EXPECT_TRUE(sends(field_, [&] { field_.clear(); }));
  EXPECT_THAT(field_.getValue(), IsEmpty());
}

TEST_F(MFieldTest, ReadingSendsNone) {
  EXPECT_FALSE(sends(field_, [&] {
    field_.getValue();
    EXPECT_EQ(field_.size(), 4U);
    EXPECT_EQ(field_.getValueByIndex(2), 4);
    EXPECT_EQ(field_.getValueAsString(), "3 1 4 1");
  }));
}

TEST_F(MFieldTest, IndexOutOfRangeIsAnErrorAndChangesNothing) {
  EXPECT_THROW(field_.getValueByIndex(4), std::out_of_range);
  EXPECT_FALSE(sends(field_, [&] { EXPECT_THROW(field_.setValue(4, 0), std::out_of_range); }));
  EXPECT_THAT(field_.getValue(), ElementsAre(3, 1, 4, 1));
}

TEST_F(MFieldTest, ChangeOfOneTakesWhatIsPendingFirst) {
  MFInt32 source;
  source.setValue({10, 20});
  source.route(field_);
  field_.push_back(30);
  EXPECT_THAT(field_.getValue(), ElementsAre(10, 20, 30));
  EXPECT_TRUE(field_.isUpToDate());
}

TEST_F(MFieldTest, RoutesAllValues) {
  MFInt32 to;
  field_.route(to);
  field_.push_back(5);
  EXPECT_THAT(to.getValue(), ElementsAre(3, 1, 4, 1, 5));
  EXPECT_EQ(to.size(), 5U);
}

TEST_F(MFieldTest, EditWritesInPlaceAndSendsOneEvent) {
  const int* data = field_.getValue().data();
  EXPECT_TRUE(sends(field_, [&] {
    field_.edit([](std::vector<int>& values) { std::iota(values.begin(), values.end(), 0); });
  }));
  EXPECT_THAT(field_.getValue(), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(field_.getValue().data(), data);
}

TEST_F(MFieldTest, UpdateReusesTheMemory) {
  MFInt32 to;
  field_.route(to);
  const int* data = to.getValue().data();
  field_.setValue(0, 9);
  EXPECT_EQ(to.getValue().data(), data);
}

TEST_F(MFieldTest, TakesAValueOfItsOwn) {
  field_.push_back(field_.getValueByIndex(2));
  field_.erase(field_.getValueByIndex(0));
  EXPECT_THAT(field_.getValue(), ElementsAre(1, 4, 1, 4));
}

TEST(MFBool, IsAFieldAsTheOthers) {
  MFBool a, b;
  a.route(b);
  a.setValue({true, false});
  a.push_back(true);
  a.setValue(0, false);
  EXPECT_EQ(b.getValueAsString(), "false false true");
  EXPECT_EQ(b.getValueByIndex(2), true);
  b.setValueFromString("true");
  EXPECT_EQ(b.getValue(), std::vector<bool>{true});
}

}  // namespace
}  // namespace pleura
