#pragma once

#include <filesystem>

namespace pleura {

/// Where Pleura's own scenes are: beside the installed program, or in the source tree that it was built from.
/// Throws FileError when neither is there.
std::filesystem::path sceneFolder();

}  // namespace pleura
