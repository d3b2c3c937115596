#pragma once

#include <vector>

#include <pleura/nodes/deformable/chainmail/chainmail_topology.h>

namespace pleura {

/// A numbering that puts neighbours near each other in memory, and back: outer[inner[point]] == point.
struct ChainmailOrder {
  std::vector<int> inner;  // the new number of each point
  std::vector<int> outer;  // the old one
};

/// Numbers the points of each connected part breadth first from its lowest (Cuthill and McKee 1969).
ChainmailOrder breadthFirstOrder(const ChainmailTopology& topology);

/// The same links under the new numbers.
ChainmailTopology renumber(const ChainmailTopology& topology, const ChainmailOrder& order);

}  // namespace pleura
