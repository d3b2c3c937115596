#pragma once

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>
#include <pleura/nodes/standard/rendering/x3d_geometry_node.h>

namespace pleura {

/// The triangles of an IndexedTriangleSet or IndexedFaceSet over the points of its Coordinate, faces of more
/// corners as fans, indices out of range left out; empty for any other geometry.
TriangleMesh restMesh(X3DGeometryNode& geometry);

}  // namespace pleura
