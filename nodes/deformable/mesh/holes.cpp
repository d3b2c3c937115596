#include <pleura/nodes/deformable/mesh/components.h>
#include <pleura/nodes/deformable/mesh/edge_uses.h>
#include <pleura/nodes/deformable/mesh/holes.h>
#include <pleura/nodes/deformable/mesh/measures.h>

namespace pleura {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
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

/// A triangle, or triangles around a point at the loop's mean, which `middle` will be.
struct Filling {
  Vector3f mean;
  std::vector<Vector3i> triangles;
};

Filling fillingOf(const std::vector<int>& loop, std::span<const Vector3f> points, int middle) {
  if (loop.size() == 3) return {Vector3f::Zero(), {{loop[0], loop[1], loop[2]}}};
  Vector3d mean = Vector3d::Zero();
  for (const int point : loop) mean += points[point].cast<double>() / static_cast<double>(loop.size());
  Filling filling{mean.cast<float>(), {}};
  for (std::size_t i = 0; i < loop.size(); ++i)
    filling.triangles.emplace_back(loop[i], loop[(i + 1) % loop.size()], middle);
  return filling;
}

/// For each triangle the area of the part it belongs to [m^2].
std::vector<double> areasOfParts(const TriangleMesh& mesh) {
  std::vector<double> areas(mesh.triangles.size());
  for (const Component& part : components(mesh.triangles)) {
    const double area = surfaceArea(mesh.points, gather(mesh.triangles, part.triangles));
    for (const int t : part.triangles) areas[t] = area;
  }
  return areas;
}

constexpr double largestFilling = 0.25;  // of its part's area

}  // namespace

std::vector<std::vector<int>> boundaryLoops(const TriangleMesh& mesh) { return loopsOf(boundaryOf(mesh)); }

int fillHoles(TriangleMesh& mesh, int maxEdges) {
  const Boundary boundary = boundaryOf(mesh);
  const std::vector<double> partArea = areasOfParts(mesh);
  int filled = 0;
  for (const std::vector<int>& loop : loopsOf(boundary)) {
    if (std::ssize(loop) > maxEdges) continue;
    const Filling filling = fillingOf(loop, mesh.points, static_cast<int>(mesh.points.size()));
    mesh.points.push_back(filling.mean);
    const bool isOutline =
        surfaceArea(mesh.points, filling.triangles) > largestFilling * partArea[boundary.triangle[loop[0]]];
    if (isOutline || loop.size() == 3) mesh.points.pop_back();
    if (isOutline) continue;
    mesh.triangles.insert(mesh.triangles.end(), filling.triangles.begin(), filling.triangles.end());
    ++filled;
  }
  return filled;
}

}  // namespace pleura
