#pragma once

#include <span>
#include <string_view>

#include <pleura/nodes/thorax/anatomy/table.h>

namespace pleura {

/// The lines of measurements/NAME.csv, compiled in; empty if there is no such table.
std::span<const std::string_view> measurementLines(std::string_view name);

/// measurements/NAME.csv; throws std::invalid_argument if there is none.
Table measurementTable(std::string_view name);

}  // namespace pleura
