#pragma once

#include <span>

#include <Eigen/Core>

#include <pleura/nodes/lung/planar/hemithorax.h>
#include <pleura/nodes/lung/planar/planar_parameters.h>

namespace pleura::planar {

/// A lung seen from its outline. Nothing pushes on the points inside, so that they follow the outline as they
/// would at rest, u_i = T u_o with T = -K_ii^-1 K_io (Guyan 1965): exact for stiffness and viscosity, and for
/// inertia as long as a motion is slow against the lung's own swinging (about 1 Hz when it hangs free; a
/// breath has 0.25 Hz). Displacements are those of the free outline points, x and y of each; the held ones do
/// not move.
struct CondensedLung {
  CondensedLung(const LungMesh& mesh, const LungTissue& tissue, double thickness);

  Eigen::Index size() const { return stiffness.rows(); }

  /// Positions [m] of all the mesh's points from the displacement of the free ones. Does not allocate.
  void place(const Eigen::VectorXd& displacement, std::span<Eigen::Vector2d> points) const;

  std::vector<Eigen::Vector2d> rest;  // [m] of all points
  Eigen::Index outlineCount = 0;
  Eigen::Index firstFree = 0;  // outline points firstFree .. firstFree + size() / 2 - 1 are free
  Eigen::MatrixXd stiffness;   // K_oo + K_oi T [N/m]
  Eigen::MatrixXd mass;        // T' M T over outline and inside [kg]
  Eigen::MatrixXd inside;      // T, a row for x and y of each point inside
};

}  // namespace pleura::planar
