#pragma once

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

#include <span>
#include <vector>

namespace pleura {

/// The closed loops of points around a surface's holes, in the direction in which a filling would run. Each
/// edge must be of at most two triangles in opposite directions and each point in one fan, as splitFans
/// leaves them.
std::vector<std::vector<int>> boundaryLoops(const TriangleMesh& mesh);

/// Closes loops of up to maxEdges edges: by a triangle if there are three, else by a fan around a new point
/// at their mean. A loop as long as its part has triangles is an outline, not a hole, and stays. Returns how
/// many.
int fillHoles(TriangleMesh& mesh, int maxEdges);

}  // namespace pleura
