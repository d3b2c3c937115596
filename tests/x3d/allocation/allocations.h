#pragma once

#include <cstdint>

namespace pleura {

/// How often memory has been asked for since this program started: by new, by malloc and its kin, by any
/// library.
std::uint64_t allocations();

}  // namespace pleura
