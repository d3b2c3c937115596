#pragma once

#include <pleura/nodes/deformable/fem/solid_body.h>

namespace pleura {

struct NewtonOptions {
  int iterations = 30;      ///< at most, linearisations a step, >= 1
  double tolerance = 1e-8;  ///< of the residual, > 0
};

/// Backward Euler with an elastic energy E(x) that is not quadratic: x minimises
///   Phi(x) = |x - x0 - h v0|^2_M / 2 h^2 + alpha |x - x0|^2_M / 2 h + beta |x - x0|^2_K0 / 2 h + E(x) - f.x
///            + k/2 |t - W x|^2
/// (K0 the tangent at x0) by Newton's method with line search. The first linearisation is that at x0 and
/// carries the fixed nodes to where they are prescribed.
class NewtonSolid : public SolidSolver {
 public:
  SolidReport step(double h, const SolidLoad& load) override;
  const SolidState& state() const override { return _state; }
  bool setState(const SolidState& state) override;
  double energy() const override { return _energy; }
  int degenerateCount() const override { return _body.elements.degenerateCount; }

  const SolidBody& body() const { return _body; }
  const NodeVectors& elasticForces() const { return _forces; }  ///< -dE/dx at the state [N]

 protected:
  /// Throws std::invalid_argument as makeSolidBody does, and on options out of range.
  NewtonSolid(SolidBody body, const NewtonOptions& options);

  /// E(x) [J] and forces = -dE/dx [N]; what it finds on the way it may keep for assemble().
  virtual double evaluate(const NodeVectors& x, NodeVectors& forces) = 0;
  /// Adds to K the tangent, positive semidefinite, at the x last evaluated.
  virtual void assemble(BlockValues& K) = 0;
  /// Called when h changes. False: singular.
  virtual bool prepare(double h) = 0;
  /// d := A^-1 b at the unknowns, 0 elsewhere; adds to the number of iterations. False: it can't.
  virtual bool solve(const BlockValues& A, const NodeVectors& b, NodeVectors& d, int& iterations) = 0;

  /// Adds the terms of inertia and damping at step h, and the soft points, to an elastic tangent.
  void addStepTerms(double h, const BlockValues& tangent, BlockValues& A) const;
  /// To be called once by the constructor of what derives from this.
  void start();

  const SolidBody _body;

 private:
  bool moveTo(double h, const SolidLoad& load, const NodeVectors& move);
  void findResidual(double h, const SolidLoad& load, const NodeVectors& move);
  void assembleSystem(double h);
  SolidReport failure(SolidOutcome outcome, const SolidReport& report);

  NewtonOptions _options;
  SolidState _state;
  NodeVectors _forces;  // elastic, at the state
  double _energy = 0;   // likewise
  double _preparedFor = 0;
  bool _isSingular = false;
  bool _isEvaluated = false;  // whether evaluate() has last seen the state
  double _stiffnessNorm = 0;  // of the diagonal at rest [N/m]
  double _energyScale = 0;    // mu times the volume [J]
  BlockValues _tangent, _dampingTangent, _system;
  // Work space: a move d from x0 and what was found there.
  NodeVectors _move, _trial, _direction, _position, _newForces, _residual, _damped;
  double _potential = 0;  // Phi, less what is the same for all x [J]
  double _magnitude = 0;  // of its terms, to tell rounding
  double _newEnergy = 0;
};

}  // namespace pleura
