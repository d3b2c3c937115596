#include <gtest/gtest.h>

#include <pleura/haptics/servo/period_statistics.h>

namespace pleura::haptics {
namespace {

TEST(PeriodStatistics, OfNothingIsZero) {
  const PeriodStatistics periods;
  EXPECT_EQ(periods.count(), 0);
  EXPECT_EQ(periods.quantile(0.5), 0);
  EXPECT_EQ(periods.longest(), 0);
}

TEST(PeriodStatistics, QuantilesAreRightToAMicrosecond) {
  PeriodStatistics periods;
  for (int k = 1; k <= 1000; ++k) periods.add(k * 1e-6, false);
  EXPECT_NEAR(periods.quantile(0.5), 500e-6, 1e-9);
  EXPECT_NEAR(periods.quantile(0.99), 990e-6, 1e-9);
  EXPECT_NEAR(periods.quantile(0.999), 999e-6, 1e-9);
  EXPECT_EQ(periods.longest(), 1000e-6);
}

TEST(PeriodStatistics, WhatIsLongerThanTheHistogramIsTheLongest) {
  PeriodStatistics periods;
  periods.add(1e-3, false);
  periods.add(2.5, true);
  EXPECT_NEAR(periods.quantile(0.5), 1e-3, 1e-9);
  EXPECT_EQ(periods.quantile(1), 2.5);
  EXPECT_EQ(periods.missed(), 1);
  EXPECT_EQ(periods.count(), 2);
}

}  // namespace
}  // namespace pleura::haptics
