#include <stdexcept>

#include <meshoptimizer.h>

#include <pleura/nodes/deformable/mesh/edge_uses.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/refinement.h>
#include <pleura/nodes/deformable/mesh/repair.h>
#include <pleura/nodes/deformable/mesh/topology.h>

namespace pleura {

using Eigen::Vector3f;
using Eigen::Vector3i;

TriangleMesh decimate(const TriangleMesh& mesh, int targetTriangles) {
  if (targetTriangles < 0) throw std::invalid_argument("targetTriangles: must not be negative");
  requireIndicesInRange(mesh.points.size(), mesh.triangles);
  requireFinite(mesh.points);
  if (targetTriangles >= std::ssize(mesh.triangles)) return mesh;
  constexpr float anyError = 1;  // relative to the surface's extent: only the count limits
  std::vector<unsigned int> indices;
  for (const Vector3i& triangle : mesh.triangles)
    for (const int corner : triangle) indices.push_back(static_cast<unsigned int>(corner));
  std::vector<unsigned int> kept(indices.size());
  kept.resize(meshopt_simplify(kept.data(), indices.data(), indices.size(), mesh.points.data()->data(),
                               mesh.points.size(), sizeof(Vector3f),
                               3 * static_cast<std::size_t>(targetTriangles), anyError, 0, nullptr));
  TriangleMesh result{mesh.points, {}};
  for (std::size_t i = 0; i < kept.size(); i += 3)
    result.triangles.emplace_back(kept[i], kept[i + 1], kept[i + 2]);
  removeUnreferencedPoints(result);
  return result;
}

TriangleMesh subdivide(const TriangleMesh& mesh) {
  requireIndicesInRange(mesh.points.size(), mesh.triangles);
  TriangleMesh result{mesh.points, {}};
  std::vector<Vector3i> middles = mesh.triangles;  // of each side; a side of no length keeps its corner
  forEachEdge(edgeUses(mesh.triangles), [&](std::span<const EdgeUse> edge) {
    const int middle = static_cast<int>(result.points.size());
    result.points.push_back(mesh.points[edge[0].low] / 2 + mesh.points[edge[0].high] / 2);
    for (const EdgeUse& use : edge) middles[use.triangle][use.side] = middle;
  });
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3i& corner = mesh.triangles[t];
    const Vector3i& middle = middles[t];
    for (int k = 0; k < 3; ++k) result.triangles.emplace_back(corner[k], middle[k], middle[(k + 2) % 3]);
    result.triangles.push_back(middle);
  }
  return result;
}

}  // namespace pleura
