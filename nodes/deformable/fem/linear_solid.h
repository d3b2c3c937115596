#pragma once

#include <pleura/nodes/deformable/fem/solid_body.h>

namespace pleura {

/// Linear elasticity: right for small rotations, factorised once for each step length,
///   M v' + D v + S (x - X) = f + k W^T (t - W X),  S = K + k W^T W.
/// Solves are direct; a residual above 1e-9 is refined, three times at most, and up to 1e-6 it counts as
/// converged.
class LinearSolid : public SolidSolver {
 public:
  /// Throws std::invalid_argument as makeSolidBody does.
  LinearSolid(const SolidMesh& mesh, const SolidMaterial& material, const SolidConstraints& constraints);

  SolidReport step(double h, const SolidLoad& load) override;
  const SolidState& state() const override { return state_; }
  bool setState(const SolidState& state) override;
  double energy() const override;
  int degenerateCount() const override { return body_.elements.degenerateCount; }

  const SolidBody& body() const { return body_; }
  const BlockValues& stiffness() const { return stiffness_; }  ///< K, without soft points [N/m]

 private:
  bool prepare(double h);
  void residualAfter(double h, NodeVectors& residual);

  SolidBody body_;
  SolidState state_;
  BlockValues stiffness_;  // K
  BlockValues total_;      // S
  BlockValues system_;     // A = (1/h^2 + alpha/h) M + (1 + beta/h) S
  BlockCholesky factor_;
  double factorisedFor_ = 0;  // h; 0: none
  bool isSingular_ = false;
  NodeVectors displacement_, restoring_;  // u, and S u of the state
  // Work space.
  NodeVectors load_, right_, move_, correction_, newDisplacement_, newRestoring_, residual_;
};

}  // namespace pleura
