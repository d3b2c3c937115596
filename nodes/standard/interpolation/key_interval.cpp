#include <algorithm>

#include <pleura/nodes/standard/interpolation/key_interval.h>

namespace pleura {

KeyInterval findKeyInterval(std::span<const float> keys, float fraction) {
  const auto above = std::upper_bound(keys.begin(), keys.end(), fraction);
  if (above == keys.begin()) return {};
  const auto from = static_cast<std::size_t>(above - keys.begin()) - 1;
  if (above == keys.end() || !(*above > keys[from])) return {from, 0};
  return {from, std::clamp((fraction - keys[from]) / (*above - keys[from]), 0.0f, 1.0f)};
}

}  // namespace pleura
