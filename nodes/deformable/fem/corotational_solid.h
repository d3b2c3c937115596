#pragma once

#include <pleura/nodes/deformable/fem/newton_solid.h>

namespace pleura {

struct CorotationalOptions : NewtonOptions {
  double linearTolerance = 1e-4;  ///< of the residual of each linear system, relative, > 0
  int linearIterations = 300;     ///< at most, >= 1
};

/// Linear elasticity in the turned frame of each quadrature point (Mueller and Gross 2004; Chao et al. 2010):
/// with F = dx/dX, R the rotation nearest to F, theta = tr(R^T F) - 3 and its mean m over the element,
///   E = sum of w [mu |F - R|^2 - mu/3 theta^2 + (lambda/2 + mu/3) m^2].
/// Large rotations, small strains: of tenfold stretch it is far from having converged after 30
/// linearisations, and says so. The tangent holds R; its systems are solved by conjugate gradients,
/// preconditioned by the factor at rest turned as each node's surroundings are. With iterations = 1 a step is
/// one linearisation, and seldom says converged.
class CorotationalSolid : public NewtonSolid {
 public:
  CorotationalSolid(const SolidMesh& mesh, const SolidMaterial& material, const SolidConstraints& constraints,
                    const CorotationalOptions& options = {});

 private:
  double evaluate(const NodeVectors& x, NodeVectors& forces) override;
  void assemble(BlockValues& K) override;
  bool prepare(double h) override;
  bool solve(const BlockValues& A, const NodeVectors& b, NodeVectors& d, int& iterations) override;
  void precondition(const NodeVectors& r, NodeVectors& z);

  CorotationalOptions options_;
  std::vector<Eigen::Matrix3d> rotation_;      // [point]
  std::vector<Eigen::Matrix3d> nodeRotation_;  // [node]
  BlockCholesky factor_;
  NodeVectors r_, z_, p_, Ap_;  // of the conjugate gradients
};

}  // namespace pleura
