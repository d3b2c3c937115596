#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// Points and triangles of a Wavefront OBJ without texture or normal indices.
inline TriangleMesh readObj(const std::filesystem::path& path) {
  TriangleMesh mesh;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Eigen::Vector3f point;
      words >> point.x() >> point.y() >> point.z();
      mesh.points.push_back(point);
    } else if (kind == "f") {
      Eigen::Vector3i corners;
      words >> corners.x() >> corners.y() >> corners.z();
      mesh.triangles.push_back(corners.array() - 1);
    }
  }
  return mesh;
}

}  // namespace pleura
