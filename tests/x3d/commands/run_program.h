#pragma once

#include <string>
#include <vector>

namespace pleura {

/// What the program ends with: all is well, the scene or the data is at fault, wrong usage.
constexpr int kDone = 0, kFault = 1, kUsage = 2;

struct Outcome {
  int status = -1;     // as the program exited; 128 + the signal that ended it; 124 when it took too long
  std::string output;  // of both streams
};

/// Runs the built program with these arguments and without a display; ended after 60 s.
Outcome runProgram(const std::vector<std::string>& arguments);

}  // namespace pleura
