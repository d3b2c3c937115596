#pragma once

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// Gives each fan of triangles around a point, joined by edges of two triangles that run through them in
/// opposite directions, a point of its own, so that sheets which only touch come apart. Afterwards each edge
/// has at most two triangles, in opposite directions: where more met, they are ends of fans, and a fan has
/// two. Adds copies at the end of the points; returns how many. Indices must be in range, and no triangle may
/// repeat a point.
int splitFans(TriangleMesh& mesh);

}  // namespace pleura
