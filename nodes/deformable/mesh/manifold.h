#pragma once

#include <vector>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// Gives each fan of triangles around a point, joined by edges of two triangles that run through them in
/// opposite directions, a point of its own, so that sheets which only touch come apart where they did. Adds
/// copies at the end of the points; returns how many. Indices must be in range.
int splitFans(TriangleMesh& mesh);

/// Takes out triangles that run through an edge in the direction in which an earlier one does: what remains
/// has at most two triangles an edge, in opposite directions. Returns how many. Triangles must not repeat a
/// point.
int dropOverlaps(std::vector<Eigen::Vector3i>& triangles);

}  // namespace pleura
