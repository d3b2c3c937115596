#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// A part of a surface whose triangles hang together by edges.
struct Component {
  std::vector<int> triangles;  // ascending
  bool isClosed = true;  // each edge is between two triangles, which run through it in opposite directions
};

/// The parts of a surface, in order of their first triangles. Triangles must not repeat a point.
std::vector<Component> components(std::span<const Eigen::Vector3i> triangles);

/// The triangles with these numbers.
std::vector<Eigen::Vector3i> gather(std::span<const Eigen::Vector3i> triangles, std::span<const int> numbers);

}  // namespace pleura
