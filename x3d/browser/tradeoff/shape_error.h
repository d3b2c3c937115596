#pragma once

#include <span>
#include <vector>

#include <pleura/fields/values.h>
#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// How far shapes are from what they should be, over the moments of a breath.
struct ShapeError {
  double rms = 0;           // [m] of the distances of points that are not driven
  double percentile95 = 0;  // [m]
  double most = 0;          // [m]
  double volume = 0;        // the largest excess or lack, of the volume
  double gap = 0;           // [m] that a neighbour comes off more than at rest
  double penetration = 0;   // [m] of a neighbour, more than at rest
};

/// Points against those of the reference, at the same moments. Those that are driven are right in both, and
/// count only towards the volume.
ShapeError shapeError(std::span<const std::vector<Vec3f>> shapes,
                      std::span<const std::vector<Vec3f>> reference,
                      std::span<const Eigen::Vector3i> triangles, std::span<const int> driven);

/// A lung and the diaphragm below it, or any closed surface and what lies beside it.
struct Neighbours {
  const TriangleMesh& closed;
  std::span<const Vec3f> beside;  // at rest [m]
};

/// Sets gap and penetration: of the points beside that are within a centimetre at rest, outside and inside
/// the closed surface, by signed distances.
void measureContact(const Neighbours& neighbours, std::span<const std::vector<Vec3f>> closed,
                    std::span<const std::vector<Vec3f>> beside, ShapeError& error);

}  // namespace pleura
