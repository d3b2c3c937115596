#include <gtest/gtest.h>

// No floating-point traps here: Mesa's software rasteriser divides by zero on purpose, on threads that
// inherit them.
int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
