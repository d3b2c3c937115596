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
  const SolidState& state() const override { return state_; }
  bool setState(const SolidState& state) override;
  double energy() const override { return energy_; }
  int degenerateCount() const override { return body_.elements.degenerateCount; }

  const SolidBody& body() const { return body_; }
  const NodeVectors& elasticForces() const { return forces_; }  ///< -dE/dx at the state [N]

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

  const SolidBody body_;

 private:
  bool moveTo(double h, const SolidLoad& load, const NodeVectors& move);
  void findResidual(double h, const SolidLoad& load, const NodeVectors& move);
  void assembleSystem(double h);
  SolidReport failure(SolidOutcome outcome, const SolidReport& report);

  NewtonOptions options_;
  SolidState state_;
  NodeVectors forces_;  // elastic, at the state
  double energy_ = 0;   // likewise
  double preparedFor_ = 0;
  bool isSingular_ = false;
  bool isEvaluated_ = false;  // whether evaluate() has last seen the state
  double stiffnessNorm_ = 0;  // of the diagonal at rest [N/m]
  double energyScale_ = 0;    // mu times the volume [J]
  BlockValues tangent_, dampingTangent_, system_;
  // Work space: a move d from x0 and what was found there.
  NodeVectors move_, trial_, direction_, position_, newForces_, residual_, damped_;
  double potential_ = 0;  // Phi, less what is the same for all x [J]
  double magnitude_ = 0;  // of its terms, to tell rounding
  double newEnergy_ = 0;
};

}  // namespace pleura
