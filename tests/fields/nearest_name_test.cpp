#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/fields/nearest_name.h>

namespace pleura {
namespace {

const std::vector<std::string_view> kKnown = {"rotation", "translation", "scale", "bboxSize"};

TEST(NearestName, IsTheOneFewestLettersAway) {
  EXPECT_EQ(nearestName("rotatoin", kKnown), "rotation");
  EXPECT_EQ(nearestName("translatio", kKnown), "translation");
  EXPECT_EQ(nearestName("BBOXSIZE", kKnown), "bboxSize");
}

TEST(NearestName, IsEmptyWhereMoreThanAThirdDiffers) {
  EXPECT_EQ(nearestName("scene", kKnown), "");  // two of five letters
  EXPECT_EQ(nearestName("seale", kKnown), "scale");
  EXPECT_EQ(nearestName("", kKnown), "");
  EXPECT_EQ(nearestName("scale", {}), "");
  EXPECT_EQ(nearestName(std::string(100000, 's'), kKnown), "");
}

TEST(NearestName, TheFirstOfEquallyNearNamesIsTaken) {
  EXPECT_EQ(nearestName("RIB_L1", std::vector<std::string_view>{"RIB_L2", "RIB_L3"}), "RIB_L2");
}

TEST(NearestName, IsToldAtTheEndOfAMessage) {
  EXPECT_EQ(didYouMean("rotation"), "; did you mean rotation?");
  EXPECT_EQ(didYouMean(""), "");
}

TEST(NearestName, SameNamesDifferInCaseAtMost) {
  EXPECT_TRUE(isSameName("Phantom", "PHANTOM"));
  EXPECT_FALSE(isSameName("Phantom", "Phantoms"));
  EXPECT_FALSE(isSameName("Phantom", "Phentom"));
}

}  // namespace
}  // namespace pleura
