#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <pleura/nodes/deformable/chainmail/chainmail_range.h>
#include <pleura/nodes/deformable/chainmail/chainmail_topology.h>

namespace pleura {
namespace {

using Link = std::pair<int, int>;

void requireInRange(std::span<const Eigen::Vector3f> rest) {
  for (std::size_t i = 0; i < rest.size(); ++i)
    requireInChainmailRange("rest point", static_cast<int>(i), rest[i]);
}

void addLink(std::vector<Link>& links, int a, int b, std::size_t pointCount) {
  for (int index : {a, b})
    if (index < 0 || static_cast<std::size_t>(index) >= pointCount)
      throw std::invalid_argument("chainmail: index " + std::to_string(index) +
                                  " is out of range, there are " + std::to_string(pointCount) + " points");
  if (a == b) return;
  links.emplace_back(a, b);
  links.emplace_back(b, a);
}

void addCoincident(std::vector<Link>& links, std::span<const Eigen::Vector3f> rest) {
  const auto key = [&](int i) { return std::array<float, 3>{rest[i].x(), rest[i].y(), rest[i].z()}; };
  std::vector<int> order(rest.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    const auto a = key(i), b = key(j);
    return a != b ? a < b : i < j;
  });
  for (std::size_t k = 1; k < order.size(); ++k)
    if (rest[order[k - 1]] == rest[order[k]]) addLink(links, order[k - 1], order[k], rest.size());
}

ChainmailTopology compress(std::vector<Link> links, std::size_t pointCount) {
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  ChainmailTopology topology;
  topology.begin.assign(pointCount + 1, 0);
  topology.neighbour.reserve(links.size());
  for (const auto& [a, b] : links) {
    ++topology.begin[a + 1];
    topology.neighbour.push_back(b);
  }
  std::partial_sum(topology.begin.begin(), topology.begin.end(), topology.begin.begin());
  return topology;
}

}  // namespace

ChainmailTopology linkTriangles(std::span<const Eigen::Vector3f> rest,
                                std::span<const Eigen::Vector3i> triangles) {
  requireInRange(rest);
  std::vector<Link> links;
  links.reserve(6 * triangles.size());
  for (const Eigen::Vector3i& t : triangles)
    for (int corner = 0; corner < 3; ++corner) addLink(links, t[corner], t[(corner + 1) % 3], rest.size());
  addCoincident(links, rest);
  return compress(std::move(links), rest.size());
}

ChainmailTopology linkEdges(std::span<const Eigen::Vector3f> rest, std::span<const Eigen::Vector2i> edges) {
  requireInRange(rest);
  std::vector<Link> links;
  links.reserve(2 * edges.size());
  for (const Eigen::Vector2i& edge : edges) addLink(links, edge[0], edge[1], rest.size());
  addCoincident(links, rest);
  return compress(std::move(links), rest.size());
}

}  // namespace pleura
