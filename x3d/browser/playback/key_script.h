#pragma once

#include <string_view>
#include <vector>

#include <pleura/nodes/core/scene_context.h>

namespace pleura {

/// A key pressed and released at a time [s] of the scene.
struct TimedKey {
  Time time = 0;
  std::string key;
};

/// Reads "2.0:p 4.0:p": times and keys, parted by blanks, put in order of time. Throws std::invalid_argument
/// with what is wrong.
std::vector<TimedKey> parseKeys(std::string_view text);

}  // namespace pleura
