#pragma once

#include <Eigen/SparseCore>

#include <pleura/nodes/lung/planar/hemithorax.h>
#include <pleura/nodes/lung/planar/planar_parameters.h>

namespace pleura::planar {

// Linear triangles (three nodes, strain constant in each): they mesh any outline, are integrated exactly and
// are what is drawn. Plane strain: the body keeps its thickness, as ribs in front and behind hold it, so that
// volume is area times thickness for lung and pleural space alike.

/// Hooke's law for strain (xx, yy, 2 xy), [Pa].
Eigen::Matrix3d planeStrain(double youngsModulus, double poissonsRatio);

/// K [N/m] over x and y of every point: K_ab = thickness |A| B_a' C B_b. Triangles may run either way round.
Eigen::SparseMatrix<double> stiffnessMatrix(const LungMesh& mesh, const LungTissue& tissue, double thickness);

/// M [kg] over x and y of every point, consistent: M_ab = density thickness |A| (1 + [a = b]) / 12.
Eigen::SparseMatrix<double> massMatrix(const LungMesh& mesh, const LungTissue& tissue, double thickness);

}  // namespace pleura::planar
