#pragma once

#include <functional>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// The surface with at most about `targetTriangles` triangles (edge collapse, meshoptimizer); boundaries stay
/// boundaries. Asked for some tens it may collapse: analyze() what comes back. The same surface if it has no
/// more. Throws std::invalid_argument on targetTriangles < 0, indices out of range and points that aren't
/// finite.
TriangleMesh decimate(const TriangleMesh& mesh, int targetTriangles);

/// Each triangle in four, by the midpoints of its edges; the shape stays exactly. The old points come first.
/// Throws std::invalid_argument on indices out of range.
TriangleMesh subdivide(const TriangleMesh& mesh);

/// Edges longer than `longest` [m] between two points that are `chosen` halved, again and again until there
/// is none; the shape stays exactly. The old points come first. Throws std::invalid_argument unless longest >
/// 0, on indices out of range and points that aren't finite.
TriangleMesh splitLongEdges(const TriangleMesh& mesh, float longest,
                            const std::function<bool(const Eigen::Vector3f&)>& chosen);

}  // namespace pleura
