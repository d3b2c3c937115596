#include <pleura/nodes/deformable/mesh/components.h>
#include <pleura/nodes/deformable/mesh/disjoint_sets.h>
#include <pleura/nodes/deformable/mesh/edge_uses.h>

namespace pleura {

std::vector<Component> components(std::span<const Eigen::Vector3i> triangles) {
  DisjointSets sets(triangles.size());
  std::vector<bool> isOpen(triangles.size(), false);
  forEachEdge(edgeUses(triangles), [&](std::span<const EdgeUse> edge) {
    for (const EdgeUse& use : edge) sets.unite(edge[0].triangle, use.triangle);
    if (!isOriented(edge)) isOpen[edge[0].triangle] = true;
  });
  std::vector<Component> result;
  std::vector<int> componentOf(triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    const int first = sets.find(t);
    if (first == t) {
      componentOf[t] = static_cast<int>(result.size());
      result.emplace_back();
    }
    componentOf[t] = componentOf[first];
    Component& component = result[componentOf[t]];
    component.triangles.push_back(t);
    component.isClosed = component.isClosed && !isOpen[t];
  }
  return result;
}

std::vector<Eigen::Vector3i> gather(std::span<const Eigen::Vector3i> triangles,
                                    std::span<const int> numbers) {
  std::vector<Eigen::Vector3i> result;
  result.reserve(numbers.size());
  for (const int t : numbers) result.push_back(triangles[t]);
  return result;
}

}  // namespace pleura
