#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/haptics/contact/four_boxes.h>

namespace pleura::haptics {
namespace {

TEST(FourBoxes, TellsHowFarAPointIs) {
  FourBoxes boxes;
  for (int k = 0; k < 4; ++k) {
    boxes.low.row(k) << static_cast<float>(2 * k), 0, 0;
    boxes.high.row(k) << static_cast<float>(2 * k + 1), 1, 1;
  }
  const FourNumbers inside = boxes.squaredDistance({0.5F, 0.5F, 0.5F});
  EXPECT_TRUE((inside == FourNumbers(0, 2.25F, 12.25F, 30.25F)).all()) << inside.transpose();
  const FourNumbers across = boxes.squaredDistance({2, 3, -1});
  EXPECT_TRUE((across == FourNumbers(1 + 4 + 1, 4 + 1, 4 + 4 + 1, 16 + 4 + 1)).all()) << across.transpose();
}

TEST(FourBoxes, EnclosesFour) {
  FourBoxes four;
  four.low << 0, 1, 2, -1, 0, 0, 3, 3, 3, 0, 5, 0;
  four.high = four.low + 1;
  FourBoxes about;
  about.enclose(2, four);
  EXPECT_TRUE((about.low.row(2) == Eigen::Array3f(-1, 0, 0).transpose()).all());
  EXPECT_TRUE((about.high.row(2) == Eigen::Array3f(4, 6, 4).transpose()).all());
  EXPECT_TRUE((about.low.row(1) == 0).all());
}

/// All sixteen patterns of signs; -0 has one, 0 has none.
TEST(FourNumbers, PutsTheNegative) {
  for (unsigned pattern = 0; pattern < 16; ++pattern) {
    FourNumbers numbers;
    std::vector<int> expected;
    for (int k = 0; k < 4; ++k) {
      const bool isNegative = (pattern >> k & 1U) != 0;
      numbers[k] = std::copysign(k == 1 ? 0.0F : 2.5F, isNegative ? -1.0F : 1.0F);
      if (isNegative) expected.push_back(40 + k);
    }
    std::array<int, 4> out;
    const int count = putNegative(numbers, 40, out.data());
    EXPECT_EQ(std::vector<int>(out.begin(), out.begin() + count), expected) << pattern;
  }
}

}  // namespace
}  // namespace pleura::haptics
