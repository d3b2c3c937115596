#include <pleura/nodes/deformable/mesh/disjoint_sets.h>
#include <pleura/nodes/deformable/mesh/edge_uses.h>
#include <pleura/nodes/deformable/mesh/manifold.h>

namespace pleura {

namespace {

/// The triangle's corner, of all 3 n, at the edge's low or high end.
int cornerAt(const EdgeUse& use, bool low) {
  return 3 * use.triangle + (low == use.forward ? use.side : (use.side + 1) % 3);
}

}  // namespace

int splitFans(TriangleMesh& mesh) {
  DisjointSets corners(3 * mesh.triangles.size());
  forEachEdge(edgeUses(mesh.triangles), [&corners](std::span<const EdgeUse> edge) {
    if (!isOriented(edge)) return;
    for (const bool low : {true, false}) corners.unite(cornerAt(edge[0], low), cornerAt(edge[1], low));
  });
  const std::size_t before = mesh.points.size();
  std::vector<bool> taken(before, false);
  std::vector<int> pointOf(3 * mesh.triangles.size());
  for (int corner = 0; corner < static_cast<int>(pointOf.size()); ++corner) {
    const int fan = corners.find(corner);
    int& index = mesh.triangles[corner / 3][corner % 3];
    if (fan == corner) {
      pointOf[fan] = index;
      if (taken[index]) {
        pointOf[fan] = static_cast<int>(mesh.points.size());
        mesh.points.push_back(Eigen::Vector3f(mesh.points[index]));
      } else {
        taken[index] = true;
      }
    }
    index = pointOf[fan];
  }
  return static_cast<int>(mesh.points.size() - before);
}

}  // namespace pleura
