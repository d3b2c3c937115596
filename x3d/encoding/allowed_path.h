#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <pleura/x3d/encoding/reader.h>

namespace pleura {

/// The file that `url` names in a file of `folder`. Nothing when it is outside of `root`, which is canonical,
/// and of the anatomy's folder, and the limits don't allow that.
std::optional<std::filesystem::path> allowedPath(const std::string& url, const std::filesystem::path& folder,
                                                 const std::filesystem::path& root,
                                                 const ReaderLimits& limits);

}  // namespace pleura
