#pragma once

#include <cstdint>
#include <string_view>

namespace pleura {

/// What a field's number measures. Inside Pleura every number is in the SI unit given by symbol().
enum class Unit : std::uint8_t {
  none,
  length,
  angle,
  time,
  mass,
  force,
  perMinute,
  area,
  volume,
  pressure,
  volumeFlow,
  speed,
  frequency,
  density,
};

/// "m", "rad", ...; empty for Unit::none.
std::string_view symbol(Unit unit);

}  // namespace pleura
