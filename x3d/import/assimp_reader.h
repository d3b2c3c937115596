#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <pleura/x3d/import/guarded_files.h>
#include <pleura/x3d/import/raw_part.h>

namespace pleura {

/// All triangles of a file, as assimp reads it. Throws std::runtime_error with its reason. On a broken file
/// it may also crash or never return: call it through isolatedCall.
std::vector<RawPart> readWithAssimp(const std::filesystem::path& file, std::unique_ptr<GuardedFiles> files);

/// Whether assimp has a reader for the file's extension.
bool isReadByAssimp(const std::filesystem::path& file);

}  // namespace pleura
