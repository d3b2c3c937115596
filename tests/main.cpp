#include <cfenv>

#include <gtest/gtest.h>

// Every test runs with floating-point traps: a NaN, an infinity from finite numbers or a division by zero
// stops it.
int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  return RUN_ALL_TESTS();
}
