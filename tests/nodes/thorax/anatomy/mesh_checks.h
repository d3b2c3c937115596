#pragma once

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

#include <Eigen/Geometry>
#include <map>
#include <utility>

namespace pleura {

/// Edges that are not shared by exactly two triangles running along them in opposite directions.
inline int openOrTwistedEdges(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> halfEdges;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) ++halfEdges[{t[k], t[(k + 1) % 3]}];
  }
  int bad = 0;
  for (const auto& [edge, count] : halfEdges) {
    const auto twin = halfEdges.find({edge.second, edge.first});
    bad += count != 1 || twin == halfEdges.end() || twin->second != 1;
  }
  return bad;
}

/// Enclosed volume [m^3], positive when normals face outwards: sum a . (b x c) / 6.
inline double enclosedVolume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const auto at = [&](int k) -> Eigen::Vector3d {
      return mesh.points[static_cast<std::size_t>(t[k])].cast<double>();
    };
    sum += at(0).dot(at(1).cross(at(2))) / 6.0;
  }
  return sum;
}

}  // namespace pleura
