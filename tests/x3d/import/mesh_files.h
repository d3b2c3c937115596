#pragma once

#include <filesystem>
#include <string>

#include <Eigen/Core>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura::files {

/// A folder of its own below the system's temporary one, gone with the object.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

TriangleMesh cube();         // [0, 1]^3
TriangleMesh bumpySphere();  // closed, 512 triangles, of radius about 1

std::string read(const std::filesystem::path& path);
std::string asObj(const TriangleMesh& mesh);

/// Writes the mesh by assimp's exporter of that id ("plyb", "glb2"); returns where.
std::filesystem::path exported(const TriangleMesh& mesh, const std::string& format, const Folder& folder);

/// The same below a node that moves it.
std::filesystem::path exportedAt(const TriangleMesh& mesh, const Eigen::Vector3f& place,
                                 const std::string& format, const Folder& folder);

}  // namespace pleura::files
