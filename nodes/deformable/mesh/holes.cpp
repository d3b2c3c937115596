#include <pleura/nodes/deformable/mesh/components.h>
#include <pleura/nodes/deformable/mesh/edge_uses.h>
#include <pleura/nodes/deformable/mesh/holes.h>

namespace pleura {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// For each point the one after it on its boundary and the triangle behind the edge between them; -1 off
/// boundaries.
struct Boundary {
  std::vector<int> next;
  std::vector<int> triangle;
};

Boundary boundaryOf(const TriangleMesh& mesh) {
  Boundary boundary{std::vector<int>(mesh.points.size(), -1), std::vector<int>(mesh.points.size(), -1)};
  forEachEdge(edgeUses(mesh.triangles), [&boundary](std::span<const EdgeUse> edge) {
    if (edge.size() != 1) return;
    const auto [from, to] =
        edge[0].forward ? std::pair(edge[0].high, edge[0].low) : std::pair(edge[0].low, edge[0].high);
    boundary.next[from] = to;
    boundary.triangle[from] = edge[0].triangle;
  });
  return boundary;
}

std::vector<std::vector<int>> loopsOf(const Boundary& boundary) {
  std::vector<std::vector<int>> loops;
  std::vector<bool> seen(boundary.next.size(), false);
  for (int start = 0; start < static_cast<int>(seen.size()); ++start) {
    std::vector<int> loop;
    int point = start;
    for (; point >= 0 && !seen[point] && boundary.next[point] >= 0; point = boundary.next[point]) {
      seen[point] = true;
      loop.push_back(point);
    }
    if (loop.size() >= 3 && point == start) loops.push_back(loop);
  }
  return loops;
}

void fill(TriangleMesh& mesh, const std::vector<int>& loop) {
  if (loop.size() == 3) {
    mesh.triangles.emplace_back(loop[0], loop[1], loop[2]);
    return;
  }
  Vector3d mean = Vector3d::Zero();
  for (const int point : loop) mean += mesh.points[point].cast<double>() / static_cast<double>(loop.size());
  const int middle = static_cast<int>(mesh.points.size());
  mesh.points.push_back(mean.cast<float>());
  for (std::size_t i = 0; i < loop.size(); ++i)
    mesh.triangles.emplace_back(loop[i], loop[(i + 1) % loop.size()], middle);
}

}  // namespace

std::vector<std::vector<int>> boundaryLoops(const TriangleMesh& mesh) { return loopsOf(boundaryOf(mesh)); }

int fillHoles(TriangleMesh& mesh, int maxEdges) {
  const Boundary boundary = boundaryOf(mesh);
  std::vector<std::size_t> partSize(mesh.triangles.size());
  for (const Component& part : components(mesh.triangles))
    for (const int t : part.triangles) partSize[t] = part.triangles.size();
  int filled = 0;
  for (const std::vector<int>& loop : loopsOf(boundary)) {
    const bool isOutline = loop.size() >= partSize[boundary.triangle[loop[0]]];
    if (isOutline || std::ssize(loop) > maxEdges) continue;
    fill(mesh, loop);
    ++filled;
  }
  return filled;
}

}  // namespace pleura
