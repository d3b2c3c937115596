#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// Rows of indices in compressed form: row i is items[offsets[i]] .. items[offsets[i + 1] - 1].
struct Adjacency {
  std::vector<int> offsets;
  std::vector<int> items;

  std::span<const int> operator[](int row) const {
    return std::span(items).subspan(offsets[row], offsets[row + 1] - offsets[row]);
  }
  int rows() const { return static_cast<int>(offsets.size()) - 1; }
};

/// Throws std::invalid_argument naming the first triangle with an index outside [0, pointCount).
void requireIndicesInRange(std::size_t pointCount, std::span<const Eigen::Vector3i> triangles);

/// For each point the triangles that use it, ascending; a triangle that uses a point twice counts once.
/// Throws std::invalid_argument on an index out of range, as do the functions below.
Adjacency incidentTriangles(std::size_t pointCount, std::span<const Eigen::Vector3i> triangles);

/// For each point the points it shares an edge with, ascending, each once.
Adjacency neighbours(std::size_t pointCount, std::span<const Eigen::Vector3i> triangles);

/// Every edge once as (smaller, larger) index, ascending.
std::vector<Eigen::Vector2i> edges(std::size_t pointCount, std::span<const Eigen::Vector3i> triangles);

}  // namespace pleura
