#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// One triangle's use of an edge: its side `side` runs from its corner `side` to the next.
struct EdgeUse {
  int low, high;  // the edge's points
  int triangle, side;
  bool forward;  // from low to high

  bool sameEdge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

/// Every side of every triangle, those of one edge next to each other, by edge and then by triangle. Sides
/// that begin and end at one point are left out.
std::vector<EdgeUse> edgeUses(std::span<const Eigen::Vector3i> triangles);

/// Calls visit(span of an edge's uses) for each edge.
template <class Visit>
void forEachEdge(std::span<const EdgeUse> uses, Visit visit) {
  for (std::size_t begin = 0; begin < uses.size();) {
    std::size_t end = begin + 1;
    while (end < uses.size() && uses[end].sameEdge(uses[begin])) ++end;
    visit(uses.subspan(begin, end - begin));
    begin = end;
  }
}

/// Two triangles meet in the edge and run through it in opposite directions, as on an oriented surface.
inline bool isOriented(std::span<const EdgeUse> edge) {
  return edge.size() == 2 && edge[0].forward != edge[1].forward;
}

}  // namespace pleura
