#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <pleura/haptics/simulated/stylus_path.h>

namespace pleura::haptics {

/// A file that is no path. what() has a line a fault: "file:line:column: what was expected, what found", up
/// to 20, and how many more there are.
struct StylusPathError : DeviceError {
  using DeviceError::DeviceError;
};

/// A path from comma separated text: columns time [s], x, y, z [m] and, optional, qx, qy, qz, qw (all four)
/// and buttons (a whole number, its bits the buttons). A first line of their names allows any order; without
/// one the order is this. Empty lines and lines that begin with # say nothing. At most a million waypoints;
/// `name` is what faults call the text. Throws StylusPathError.
StylusPath parseStylusPath(std::string_view text, const std::string& name);

/// The same from a file of at most 256 MB. Throws StylusPathError.
StylusPath readStylusPath(const std::filesystem::path& file);

}  // namespace pleura::haptics
