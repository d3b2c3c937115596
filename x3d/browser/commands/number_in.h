#pragma once

#include <CLI/CLI.hpp>

namespace pleura {

/// Admits numbers from `least` to `most` and nothing else; CLI::Range lets NaN through.
CLI::Validator numberIn(double least, double most);

}  // namespace pleura
