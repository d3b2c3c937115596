#pragma once

#include <span>
#include <vector>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// The closed loops of points around a surface's holes, in the direction in which a filling would run. Each
/// edge must be of at most two triangles in opposite directions and each point in one fan, as splitFans
/// leaves them.
std::vector<std::vector<int>> boundaryLoops(const TriangleMesh& mesh);

/// Closes loops of up to maxEdges edges: by a triangle if there are three, else by a fan around a new point
/// at their mean. A loop whose filling has more than a quarter of its part's area is an outline, not a hole,
/// and stays open. Returns how many were closed.
int fillHoles(TriangleMesh& mesh, int maxEdges);

}  // namespace pleura
