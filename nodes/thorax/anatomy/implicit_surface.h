#pragma once

#include <functional>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// A solid as a function that is negative inside, zero on the skin, and near it about the distance to it [m].
using Solid = std::function<double(const Eigen::Vector3d&)>;

/// Union and intersection of solids a and b whose seam is rounded over a width k [m] (polynomial smooth
/// minimum, Quilez 2013): where |a - b| >= k they are exactly min(a, b) and max(a, b).
double smoothUnion(double a, double b, double k);
double smoothIntersection(double a, double b, double k);

/// Distance to a cone with round ends from a (radius ra) to b (radius rb), exact for ra = rb [m].
double roundCone(const Eigen::Vector3d& point, const Eigen::Vector3d& a, double ra, const Eigen::Vector3d& b,
                 double rb);

/// One step of Newton's from a point near the skin onto it, no longer than `longest` [m].
Eigen::Vector3d nearestOnSkin(const Solid& solid, const Eigen::Vector3d& point, double longest);

/// The skin of a solid: closed, normals outwards, triangles of about `spacing` [m] (surface nets, Gibson
/// 1998; then smoothed along the skin and put back on it). Throws std::invalid_argument if spacing is not
/// positive or the solid does not lie within the box.
TriangleMesh skinOf(const Solid& solid, const Eigen::AlignedBox3d& box, double spacing);

}  // namespace pleura
