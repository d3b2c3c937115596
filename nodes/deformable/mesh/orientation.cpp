#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <pleura/nodes/deformable/mesh/components.h>
#include <pleura/nodes/deformable/mesh/edge_uses.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/orientation.h>
#include <pleura/nodes/deformable/mesh/surface_query.h>

namespace pleura {

namespace {

using Eigen::Vector3i;

void turn(Vector3i& triangle) { std::swap(triangle[1], triangle[2]); }

/// The triangle across a side, where two meet, and whether it runs the same way and so must be turned against
/// it.
struct Across {
  int triangle = -1;
  bool opposed = false;
};

std::vector<std::array<Across, 3>> trianglesAcross(std::span<const Vector3i> triangles) {
  std::vector<std::array<Across, 3>> across(triangles.size());
  forEachEdge(edgeUses(triangles), [&across](std::span<const EdgeUse> edge) {
    if (edge.size() != 2) return;
    const bool opposed = !isOriented(edge);
    across[edge[0].triangle][edge[0].side] = {edge[1].triangle, opposed};
    across[edge[1].triangle][edge[1].side] = {edge[0].triangle, opposed};
  });
  return across;
}

/// Spreads from one triangle to all that hang together with it: `part` collects them, `turned` says which to
/// turn.
void spread(int seed, const std::vector<std::array<Across, 3>>& across, std::vector<bool>& seen,
            std::vector<bool>& turned, std::vector<int>& part) {
  part.assign(1, seed);
  seen[seed] = true;
  for (std::size_t i = 0; i < part.size(); ++i) {
    for (const Across& next : across[part[i]]) {
      if (next.triangle < 0 || seen[next.triangle]) continue;
      seen[next.triangle] = true;
      turned[next.triangle] = turned[part[i]] != next.opposed;
      part.push_back(next.triangle);
    }
  }
}

/// Whether a ray from each of the part's triangles crosses the other parts an odd number of times. Takes the
/// crossings from those that are left.
bool isEnclosed(const Component& part, const std::vector<int>& partOf, const SurfaceQuery& surface,
                std::size_t& crossingsLeft) {
  const Eigen::Vector3d direction(0.8017, 0.2673, 0.5345);  // along no edge of a grid
  const int self = partOf[part.triangles.front()];
  return std::ranges::all_of(part.triangles, [&](int t) {
    const Eigen::Vector3d from = surface.points()[surface.triangles()[t][0]].cast<double>();
    const std::vector<SurfacePoint> hits = surface.rayHits(from, direction);
    if (hits.size() > crossingsLeft)
      throw std::invalid_argument("triangles: too many parts lie in each other to tell which are cavities");
    crossingsLeft -= hits.size();
    const auto others = [&](const SurfacePoint& hit) { return partOf[hit.triangle] != self; };
    return std::ranges::count_if(hits, others) % 2 == 1;
  });
}

}  // namespace

int orientConsistently(std::span<Vector3i> triangles) {
  const auto across = trianglesAcross(triangles);
  std::vector<bool> seen(triangles.size(), false), turned(triangles.size(), false);
  std::vector<int> part;
  int count = 0;
  for (int seed = 0; seed < static_cast<int>(triangles.size()); ++seed) {
    if (seen[seed]) continue;
    spread(seed, across, seen, turned, part);
    const auto minority = std::ranges::count_if(part, [&turned](int t) { return turned[t]; });
    const bool mostTurned = 2 * minority > std::ssize(part);
    for (const int t : part) {
      if (turned[t] == mostTurned) continue;
      turn(triangles[t]);
      ++count;
    }
  }
  return count;
}

int faceOutwards(std::span<const Eigen::Vector3f> points, std::span<Vector3i> triangles,
                 std::size_t mostCrossings) {
  const std::vector<Component> parts = components(triangles);
  std::vector<int> partOf(triangles.size());
  std::vector<int> insideOut;
  for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
    for (const int t : parts[i].triangles) partOf[t] = i;
    if (parts[i].isClosed && signedVolume(points, gather(triangles, parts[i].triangles)) < 0)
      insideOut.push_back(i);
  }
  if (insideOut.empty()) return 0;
  const SurfaceQuery surface(points, triangles);
  const auto isCavity = [&](int i) { return isEnclosed(parts[i], partOf, surface, mostCrossings); };
  std::erase_if(insideOut, isCavity);
  for (const int i : insideOut)
    for (const int t : parts[i].triangles) turn(triangles[t]);
  return static_cast<int>(insideOut.size());
}

}  // namespace pleura
