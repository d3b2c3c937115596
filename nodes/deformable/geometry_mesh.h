#pragma once

#include <vector>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>
#include <pleura/nodes/standard/rendering/x3d_geometry_node.h>

namespace pleura {

/// The triangles of an IndexedTriangleSet or IndexedFaceSet with that many points, faces of more corners as
/// fans, those with indices out of range left out; none for any other geometry. Reads no point.
std::vector<Eigen::Vector3i> trianglesOf(X3DGeometryNode& geometry, std::size_t points);

/// The same with the points of its Coordinate, as they are now.
TriangleMesh meshOf(X3DGeometryNode& geometry);

}  // namespace pleura
