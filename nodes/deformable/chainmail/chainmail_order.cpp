#include <algorithm>

#include <pleura/nodes/deformable/chainmail/chainmail_order.h>

namespace pleura {

ChainmailOrder breadthFirstOrder(const ChainmailTopology& topology) {
  ChainmailOrder order;
  order.inner.assign(topology.pointCount(), -1);
  order.outer.reserve(topology.pointCount());
  const auto number = [&](int point) {
    if (order.inner[point] >= 0) return;
    order.inner[point] = static_cast<int>(order.outer.size());
    order.outer.push_back(point);
  };
  for (int start = 0; start < topology.pointCount(); ++start) {
    std::size_t next = order.outer.size();
    number(start);
    for (; next < order.outer.size(); ++next) {
      const int a = order.outer[next];
      for (int link = topology.begin[a]; link < topology.begin[a + 1]; ++link)
        number(topology.neighbour[link]);
    }
  }
  return order;
}

ChainmailTopology renumber(const ChainmailTopology& topology, const ChainmailOrder& order) {
  ChainmailTopology result;
  result.begin.assign(1, 0);
  result.neighbour.reserve(topology.neighbour.size());
  for (const int a : order.outer) {
    const auto row =
        result.neighbour.insert(result.neighbour.end(), topology.neighbour.begin() + topology.begin[a],
                                topology.neighbour.begin() + topology.begin[a + 1]);
    std::transform(row, result.neighbour.end(), row, [&](int b) { return order.inner[b]; });
    std::sort(row, result.neighbour.end());
    result.begin.push_back(static_cast<int>(result.neighbour.size()));
  }
  return result;
}

}  // namespace pleura
