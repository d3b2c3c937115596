#pragma once

#include <pleura/nodes/deformable/fem/newton_solid.h>

namespace pleura {

/// Stable Neo-Hookean elasticity (Smith, de Goes and Kim 2018), large strains, the reference: with F = dx/dX,
/// J = det F, I = |F|^2, m the mean of J over the element, kappa = lambda + 2/3 mu,
///   E = sum of w [2/3 mu (I - 3) - 2/3 mu log((I + 1) / 4) - mu (J - 1) + mu/12 (J - 1)^2 + kappa/2 (m -
///   1)^2],
/// which is theirs where m = J (tetrahedra) and does not lock in hexahedra. The tangent is consistent, its
/// part from each quadrature point projected to positive semidefinite, and factorised anew in each
/// linearisation.
class NeoHookeanSolid : public NewtonSolid {
 public:
  NeoHookeanSolid(const SolidMesh& mesh, const SolidMaterial& material, const SolidConstraints& constraints,
                  const NewtonOptions& options = {});

 private:
  double evaluate(const NodeVectors& x, NodeVectors& forces) override;
  void assemble(BlockValues& K) override;
  bool prepare(double) override { return true; }
  bool solve(const BlockValues& A, const NodeVectors& b, NodeVectors& d, int& iterations) override;

  std::vector<Eigen::Matrix3d> F_;    // [point]
  std::vector<double> meanJacobian_;  // [element]
  BlockCholesky factor_;
};

}  // namespace pleura
