#pragma once

#include <stdexcept>

#include <fmt/format.h>

namespace pleura::render {

/// Throws std::invalid_argument that says `what` unless it holds. Nothing is written, and no memory taken,
/// while all is well: this is asked of every frame.
template <class... Args>
void require(bool holds, fmt::format_string<const Args&...> what, const Args&... args) {
  if (!holds) throw std::invalid_argument(fmt::format(what, args...));
}

}  // namespace pleura::render
