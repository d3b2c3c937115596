#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// Turns triangles around until those that share an edge run through it in opposite directions, where that
/// can be (not on a Moebius strip, nor across edges of more than two triangles). Each part keeps the sense
/// most of its triangles had. Returns how many were turned. Linear but for sorting edges.
int orientConsistently(std::span<Eigen::Vector3i> triangles);

/// Turns closed parts with a negative volume to face outwards. A part that lies wholly inside others keeps
/// its sense: it may be a cavity. Returns how many parts were turned. Indices must be in range, points
/// finite. Throws std::invalid_argument, and turns none, when the rays that tell cavities cross the surface
/// over `mostCrossings` times: thousands of parts that lie in each other.
int faceOutwards(std::span<const Eigen::Vector3f> points, std::span<Eigen::Vector3i> triangles,
                 std::size_t mostCrossings = std::size_t{1} << 25);

}  // namespace pleura
