#pragma once

#include <gtest/gtest.h>

namespace pleura {

/// Only what `pressure` is above `restPressure` moves what a deformer holds: 50 Pa above any is the same.
template <class Deformer, class VolumeOf>
void expectOnlyPressureAboveThatAtRestCounts(Deformer& deformer, double restVolume, VolumeOf volumeOf) {
  deformer.restPressure.setValue(500);
  deformer.pressure.setValue(500);
  EXPECT_NEAR(volumeOf(deformer), restVolume, 1e-6 * restVolume);
  deformer.pressure.setValue(550);
  const double above = volumeOf(deformer);
  deformer.restPressure.setValue(0);
  deformer.pressure.setValue(50);
  EXPECT_DOUBLE_EQ(volumeOf(deformer), above);
  EXPECT_GT(above, 1.01 * restVolume);
}

}  // namespace pleura
