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
  const SolidState& state() const override { return _state; }
  bool setState(const SolidState& state) override;
  double energy() const override;
  int degenerateCount() const override { return _body.elements.degenerateCount; }

  const SolidBody& body() const { return _body; }
  const BlockValues& stiffness() const { return _stiffness; }  ///< K, without soft points [N/m]

 private:
  bool prepare(double h);
  void residualAfter(double h, NodeVectors& residual);

  SolidBody _body;
  SolidState _state;
  BlockValues _stiffness;  // K
  BlockValues _total;      // S
  BlockValues _system;     // A = (1/h^2 + alpha/h) M + (1 + beta/h) S
  BlockCholesky _factor;
  double _factorisedFor = 0;  // h; 0: none
  bool _isSingular = false;
  NodeVectors _displacement, _restoring;  // u, and S u of the state
  // Work space.
  NodeVectors _load, _right, _move, _correction, _newDisplacement, _newRestoring, _residual;
};

}  // namespace pleura
