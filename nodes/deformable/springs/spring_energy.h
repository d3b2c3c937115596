#pragma once

#include <span>

#include <pleura/nodes/deformable/springs/spring_workspace.h>

namespace pleura {

/// What is minimised to bring a surface to rest: the energy of its springs and its interior,
///   E = sum k/2 (L - l)^2 + W(V).
void prepareForRest(const SpringModel& model, SpringWorkspace& workspace);

/// What is minimised for a step of backward Euler: E, and inertia and dampers (as potentials of the step, see
/// Gast et al. 2015, Optimization Integrator for Large Time Steps),
///   E + sum m/2 |x - x_0 - step v_0|^2 / step^2 + sum c/2 (L - L_0)^2 / step.
void prepareForStep(const SpringModel& model, SpringWorkspace& workspace,
                    std::span<const Eigen::Vector3d> positions, std::span<const Eigen::Vector3d> velocities,
                    double step);

/// The value of what is minimised, and what follows from it.
struct SpringEnergy {
  double energy = 0;     // [J]
  double magnitude = 0;  // sum of the sizes of its parts [J]: its rounding is of this
  double volume = 0;     // [m^3]; 0 around an empty interior
  InteriorState interior;
  double unbalanced = 0;  // norm of the gradient [N]
};

/// Value, and into the workspace its gradient, the volume's and the springs' tangents, at workspace.trial.
/// The tangents are positive semi-definite: what a shortened spring loses sideways counts as 0 (Choi and Ko
/// 2002, Stable but Responsive Cloth), and the volume's own second derivative is left out.
SpringEnergy evaluateSprings(const SpringModel& model, SpringWorkspace& workspace);

/// E at these positions [J].
double storedEnergy(const SpringModel& model, SpringWorkspace& workspace,
                    std::span<const Eigen::Vector3d> positions);

}  // namespace pleura
