#pragma once

#include <cstddef>
#include <span>

namespace pleura {

/// A place among keys: `share` of the way from key number `from` to the next.
struct KeyInterval {
  std::size_t from = 0;
  float share = 0;  // [0, 1)
};

/// Where `fraction` lies among keys that rise; there is at least one. Before the first and beyond the last it
/// is at that key. Where keys are equal the last of them counts; where they fall, some place.
KeyInterval findKeyInterval(std::span<const float> keys, float fraction);

}  // namespace pleura
