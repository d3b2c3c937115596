#pragma once

#include <vector>

#include <pleura/nodes/thorax/anatomy/anatomy.h>

namespace pleura {

/// A long bone's lines, found on its mesh.
struct BoneLines {
  std::vector<Eigen::Vector3f> centreline;  // equal arc lengths
  std::vector<Eigen::Vector3f> innerLine;   // the mesh's points that face the lung, one a centreline sample
};

/// Cuts a long bone into slices of equal distance from its end along the surface; the line through their
/// middles starts at the end nearer to `start`. Throws std::invalid_argument if the mesh is empty or has more
/// than one piece.
BoneLines boneLines(const TriangleMesh& mesh, const Eigen::Vector3f& start, Side side, int samples);

}  // namespace pleura
