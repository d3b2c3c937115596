#pragma once

#include <Eigen/Core>
#include <assimp/scene.h>

#include <pleura/x3d/import/mesh_import.h>

namespace pleura {

/// Takes over all triangles of what assimp read, its points moved by the nodes' transforms and then by
/// `frame`. Believes nothing: throws MeshImportError, naming `file`, on indices out of range, coordinates
/// that aren't finite or beyond a float, and more triangles than fit in memory.
ImportedScene partsOf(const aiScene& scene, const std::filesystem::path& file, const Eigen::Matrix3d& frame);

}  // namespace pleura
