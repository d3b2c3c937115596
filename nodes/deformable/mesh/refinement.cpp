#include <array>
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

namespace {

constexpr int kWhole = -1;  // of a side that is not split

/// The pieces of a triangle some of whose sides have middles: an ear at each corner between two of them, and
/// from a middle the fan of what remains.
void addPieces(const Vector3i& corner, const Vector3i& middle, std::vector<Vector3i>& triangles) {
  std::array<int, 6> ring;  // at least 3 are left
  int size = 0;
  int first = 0;
  for (int k = 0; k < 3; ++k) {
    const int before = middle[(k + 2) % 3];
    if (before != kWhole && middle[k] != kWhole) {
      triangles.emplace_back(corner[k], middle[k], before);
    } else {
      ring[size++] = corner[k];
    }
    if (middle[k] == kWhole) continue;
    first = size;
    ring[size++] = middle[k];
  }
  for (int k = 1; k + 1 < size; ++k)
    triangles.emplace_back(ring[first], ring[(first + k) % size], ring[(first + k + 1) % size]);
}

}  // namespace

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

TriangleMesh splitLongEdges(const TriangleMesh& mesh, float longest,
                            const std::function<bool(const Vector3f&)>& chosen) {
  if (!(longest > 0)) throw std::invalid_argument("longest: must be positive");
  requireIndicesInRange(mesh.points.size(), mesh.triangles);
  requireFinite(mesh.points);
  TriangleMesh result = mesh;
  for (std::size_t before = 0; before != result.points.size();) {
    before = result.points.size();
    std::vector<Vector3i> middles(result.triangles.size(), Vector3i::Constant(kWhole));
    forEachEdge(edgeUses(result.triangles), [&](std::span<const EdgeUse> edge) {
      const Vector3f a = result.points[edge[0].low], b = result.points[edge[0].high];
      if ((b - a).norm() <= longest || !chosen(a) || !chosen(b)) return;
      for (const EdgeUse& use : edge)
        middles[use.triangle][use.side] = static_cast<int>(result.points.size());
      result.points.push_back(a / 2 + b / 2);
    });
    std::vector<Vector3i> pieces;
    for (std::size_t t = 0; t < middles.size(); ++t) addPieces(result.triangles[t], middles[t], pieces);
    result.triangles = std::move(pieces);
  }
  return result;
}

}  // namespace pleura
