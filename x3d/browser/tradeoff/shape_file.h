#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <pleura/fields/values.h>

namespace pleura {

/// Shapes of an organ, one a moment, as they are in memory: kept for the next run on the same machine. Throws
/// std::runtime_error when the file can't be written.
void writeShapes(const std::filesystem::path& file, const std::vector<std::vector<Vec3f>>& shapes);

/// Nothing unless the file holds exactly that many, all finite.
std::optional<std::vector<std::vector<Vec3f>>> readShapes(const std::filesystem::path& file,
                                                          std::size_t moments, std::size_t points);

}  // namespace pleura
