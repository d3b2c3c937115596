#pragma once

#include <cstdint>

namespace pleura {

/// What the fields of the calling thread have done since it started: laziness made visible. Read it before
/// and after a tick and subtract.
struct FieldCounters {
  std::uint64_t updates = 0;  // calls of Field::update()
  std::uint64_t events = 0;   // events accepted by a field from a route
};

FieldCounters& fieldCounters();

}  // namespace pleura
