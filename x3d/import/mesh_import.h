#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// A mesh file that can't be used. The message is "FILE: why".
struct MeshImportError : std::runtime_error {
  MeshImportError(const std::filesystem::path& file, const std::string& why)
      : std::runtime_error(file.string() + ": " + why) {}
};

struct MeshImportOptions {
  double scale = 1;                                    // metres in the file's unit of length
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // file's axes to X3D's, before scale; may mirror
};

/// The axes a text such as "x z -y" names: X3D's x, y and z in the file's terms. Commas count as blanks.
/// Throws std::invalid_argument unless each of x, y and z is named once.
Eigen::Matrix3d axesNamed(const std::string& text);

struct ImportedPart {
  std::string name;  // the file's own for it, else the file's stem; not always unique
  TriangleMesh mesh;
  Eigen::Vector4f colour = {0.8f, 0.8f, 0.8f, 1};  // diffuse red, green, blue and opacity, in [0, 1]
};

struct ImportedScene {
  std::vector<ImportedPart> parts;
  std::vector<std::string> diagnostics;  // "PART: fault", as analyze() finds them; points and lines left out
};

/// Reads OBJ, STL, PLY, glTF or what else assimp knows. Polygons become triangles, points at the same place
/// one point in order of first use, and the parts stand where the file's nodes put them. Throws
/// MeshImportError if the file can't be read or has no triangles, and on coordinates that aren't finite. The
/// reading itself is done in a process of its own (isolatedCall): assimp crashes on some broken files.
ImportedScene importMesh(const std::filesystem::path& file, const MeshImportOptions& options = {});

/// The same from memory; `name` ("left_lung.obj") tells the format and stands in messages.
ImportedScene importMesh(std::span<const std::byte> content, const std::string& name,
                         const MeshImportOptions& options = {});

}  // namespace pleura
