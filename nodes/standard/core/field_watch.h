#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include <pleura/fields/field.h>

namespace pleura {

/// Remembers a set of fields by their newest stamp.
class FieldWatch {
 public:
  /// Whether any of the fields, brought up to date first, has changed since the last call; the first says
  /// yes.
  template <class... Fields>
  bool changed(Fields&... fields) {
    (fields.upToDate(), ...);
    const std::uint64_t newest = std::max({fields.getStamp()...});
    const bool isNews = newest != seen_;
    seen_ = newest;
    return isNews;
  }

 private:
  std::uint64_t seen_ = std::numeric_limits<std::uint64_t>::max();
};

}  // namespace pleura
