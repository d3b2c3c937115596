#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <pleura/x3d/browser/playback/key_script.h>

namespace pleura {

std::vector<TimedKey> parseKeys(std::string_view text) {
  std::vector<TimedKey> keys;
  std::istringstream parts{std::string(text)};
  for (std::string part; parts >> part;) {
    const auto colon = part.find(':');
    TimedKey key;
    const auto [end, error] =
        std::from_chars(part.data(), part.data() + std::min(colon, part.size()), key.time);
    const bool isTime = error == std::errc() && std::isfinite(key.time) && key.time >= 0;
    if (colon == std::string::npos || !isTime || end != part.data() + colon || colon + 1 == part.size())
      throw std::invalid_argument("keys: expected SECONDS:KEY, found " + part);
    key.key = part.substr(colon + 1);
    keys.push_back(std::move(key));
  }
  std::stable_sort(keys.begin(), keys.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return keys;
}

}  // namespace pleura
