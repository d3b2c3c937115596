#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// A surface whose holes have lids: along each edge as many triangles run one way as the other, so that it
/// winds around every place a whole number of times.
struct ClosedSurface {
  TriangleMesh mesh;       // lids last
  int lidsBegin = 0;       // triangles from here on are lids
  std::vector<int> parts;  // of each triangle: those that hang together by edges have one number
  int partCount = 0;
  double volume = 0;  // [m^3] signed, lids included

  int droppedTriangles = 0;  // of repeated points, duplicates
  int openEdges = 0;         // closed by lids
  int holes = 0;
  bool wasInsideOut = false;  // all of it was turned
  int turnedTriangles = 0;    // besides, against their neighbours
  int turnedParts = 0;        // besides, as a whole
};

/// More than a body's surface needs, and what is repaired in seconds.
inline constexpr std::size_t kMostSurfaceTriangles = 4'000'000;

/// Repairs and closes a surface: each hole gets a fan around the mean of its edge's points. Over a plane hole
/// that is where the winding number of the open surface is one half (Jacobson et al. 2013), and it costs
/// nothing for each place asked about. Parts face outwards but for cavities. Throws std::invalid_argument on
/// no triangles or over kMostSurfaceTriangles, points that aren't finite, indices out of range, where over a
/// quarter of the edges is open, and as faceOutwards does. Memory: about 400 bytes a triangle of its own
/// points.
ClosedSurface closeSurface(std::span<const Eigen::Vector3f> points,
                           std::span<const Eigen::Vector3i> triangles);

}  // namespace pleura
