#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// Which points are linked, as compressed rows: the neighbours of point a are
/// neighbour[begin[a]] ... neighbour[begin[a + 1] - 1], ascending, each once; b is in a's row when a is in
/// b's.
struct ChainmailTopology {
  std::vector<int> begin;      // pointCount() + 1
  std::vector<int> neighbour;  // two for each link

  int pointCount() const { return static_cast<int>(begin.size()) - 1; }
  int linkCount() const { return static_cast<int>(neighbour.size()) / 2; }
};

/// The links along the edges of a surface, and between points at the very same place (a seam in the mesh is
/// none in the organ). Degenerate triangles and points without any are allowed. Throws std::invalid_argument
/// on an index out of range or a point that is not finite.
ChainmailTopology linkTriangles(std::span<const Eigen::Vector3f> rest,
                                std::span<const Eigen::Vector3i> triangles);

/// The same from a list of edges, for curves and volume meshes.
ChainmailTopology linkEdges(std::span<const Eigen::Vector3f> rest, std::span<const Eigen::Vector2i> edges);

}  // namespace pleura
