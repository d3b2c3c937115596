#include <cfenv>

#include <gtest/gtest.h>
#include <libxml/parser.h>

// As tests/main.cpp, but libxml2 makes its NaN and infinities by dividing by zero once: before the traps are
// set.
int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  xmlInitParser();
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  return RUN_ALL_TESTS();
}
