#pragma once

#include <string>
#include <vector>

namespace pleura {

struct Outcome {
  int status = -1;     // as the program exited; 128 + the signal that ended it; 124 when it took too long
  std::string output;  // of both streams
};

/// Runs the built program with these arguments and without a display; ended after 60 s.
Outcome runProgram(const std::vector<std::string>& arguments);

}  // namespace pleura
