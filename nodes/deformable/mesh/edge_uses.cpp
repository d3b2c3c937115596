#include <algorithm>
#include <tuple>

#include <pleura/nodes/deformable/mesh/edge_uses.h>

namespace pleura {

std::vector<EdgeUse> edgeUses(std::span<const Eigen::Vector3i> triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int side = 0; side < 3; ++side) {
      const int from = triangles[t][side], to = triangles[t][(side + 1) % 3];
      if (from == to) continue;
      uses.push_back({std::min(from, to), std::max(from, to), static_cast<int>(t), side, from < to});
    }
  }
  const auto key = [](const EdgeUse& use) { return std::tie(use.low, use.high, use.triangle, use.side); };
  std::sort(uses.begin(), uses.end(), [key](const EdgeUse& a, const EdgeUse& b) { return key(a) < key(b); });
  return uses;
}

}  // namespace pleura
