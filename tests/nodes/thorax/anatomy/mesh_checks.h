#pragma once

#include <pleura/nodes/deformable/mesh/edge_uses.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// Edges that are not shared by exactly two triangles running along them in opposite directions.
inline int openOrTwistedEdges(const TriangleMesh& mesh) {
  const std::vector<EdgeUse> uses = edgeUses(mesh.triangles);
  int bad = 0;
  for (std::size_t i = 0, next = 0; i < uses.size(); i = next) {
    while (next < uses.size() && uses[next].sameEdge(uses[i])) ++next;
    bad += next - i != 2 || uses[i].forward == uses[i + 1].forward;
  }
  return bad;
}

inline double enclosedVolume(const TriangleMesh& mesh) { return signedVolume(mesh.points, mesh.triangles); }

/// Smallest angle of each triangle [rad].
inline std::vector<double> smallestAngles(const TriangleMesh& mesh) {
  std::vector<double> angles;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    double smallest = 4.0;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = mesh.points[t[k]].cast<double>();
      const Eigen::Vector3d b = mesh.points[t[(k + 1) % 3]].cast<double>();
      const Eigen::Vector3d c = mesh.points[t[(k + 2) % 3]].cast<double>();
      smallest = std::min(smallest, angleBetween(b - a, c - a));
    }
    angles.push_back(smallest);
  }
  return angles;
}

}  // namespace pleura
