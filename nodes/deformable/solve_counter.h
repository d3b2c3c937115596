#pragma once

#include <cstdint>

namespace pleura {

/// How many times a deformer was run by the calling thread: what is hidden and not asked for is not solved.
std::uint64_t& solveCounter();

}  // namespace pleura
