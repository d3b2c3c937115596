#pragma once

#include <vector>

#include <pleura/nodes/thorax/anatomy/anatomy.h>

namespace pleura {

/// A long bone's lines, found on its mesh.
struct BoneLines {
  std::vector<Eigen::Vector3f> centreline;  // equal arc lengths
  std::vector<Eigen::Vector3f> innerLine;   // the mesh's points that face the lung, one a centreline sample
};

/// The piece of a mesh with the most triangles: scans carry crumbs. Throws std::invalid_argument if there is
/// none.
TriangleMesh largestPiece(const TriangleMesh& mesh);

/// Cuts a long bone of one piece into slices of equal distance from its end along the surface; the line
/// through their middles starts at the end nearer to `start`.
BoneLines boneLines(const TriangleMesh& mesh, const Eigen::Vector3f& start, Side side, int samples);

}  // namespace pleura
