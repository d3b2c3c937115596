#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// Stiffness [N/m] of the springs along `edges` (each once, as mesh/topology.h lists them) that make the
/// surface a membrane of modulus E [N/m] (Young's modulus times thickness), however fine its mesh:
///   k = E sum(A) / l^2,  A the areas of the triangles at the edge and l its length
/// (Van Gelder 1998, Approximate Simulation of Elastic Membranes by Triangulated Spring Meshes). It is exact
/// for equal stretch in all directions, on any mesh, at the Poisson's ratio that springs have, 1/3; for every
/// stretch on equilateral triangles, where k = sqrt(3)/2 E. Kept within E/1000 and 1000 E, for slivers.
/// Throws std::invalid_argument on an index out of range, a point that is not finite, or E not above 0.
std::vector<double> membraneStiffness(std::span<const Eigen::Vector3f> rest,
                                      std::span<const Eigen::Vector3i> triangles,
                                      std::span<const Eigen::Vector2i> edges, double modulus);

}  // namespace pleura
