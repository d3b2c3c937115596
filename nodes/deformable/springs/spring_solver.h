#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/springs/spring_model.h>
#include <pleura/nodes/deformable/springs/spring_workspace.h>

namespace pleura {

struct SpringOptions {
  double tolerance = 1e-6;        // of the residual, and of the excess of a volume that is held; above 0
  int maxIterations = 50;         // of Newton's method, 1 or more
  int maxLinearIterations = 500;  // of conjugate gradients in each of those, 1 or more
};

/// What a solve did.
struct SpringReport {
  bool refused = false;      // input that is not sound: nothing was touched
  bool converged = false;    // residual, and volume where held, are within the tolerance
  int iterations = 0;        // of Newton's method
  int linearIterations = 0;  // of conjugate gradients, all together
  double residual = 0;       // norm of the unbalanced forces, in model.forceUnit
  double volume = 0;         // [m^3]; 0 around an empty interior
  double pressure = 0;       // inside less outside [Pa]
};

/// Moves point driven[i] exactly to targets[i] [m] and the others to where all forces balance, from rest,
/// carried along with the driven points. Earlier solves don't change a bit. Positions are refused or finite,
/// and of no more energy than the start; how well they balance is in the report. Refused are sizes and
/// indices that don't fit, targets beyond kSpringFarthest or not numbers, two targets for one point, options
/// out of range. Doesn't throw, doesn't allocate.
SpringReport solveSprings(const SpringModel& model, SpringWorkspace& workspace, std::span<const int> driven,
                          std::span<const Eigen::Vector3d> targets, const SpringOptions& options,
                          std::span<Eigen::Vector3d> positions);

/// A surface in motion.
struct SpringState {
  std::vector<Eigen::Vector3d> positions;   // [m]
  std::vector<Eigen::Vector3d> velocities;  // [m/s]
};

/// The model at rest.
SpringState restingState(const SpringModel& model);

/// Advances the state by `step` [s] (1e-6 to 1e3) of backward Euler; driven points go to their targets in
/// that time. No step gains energy but by driven points that move or a given pressure. Else as above; what is
/// not finite in the state, or a step out of range, is refused.
SpringReport stepSprings(const SpringModel& model, SpringWorkspace& workspace, std::span<const int> driven,
                         std::span<const Eigen::Vector3d> targets, double step, const SpringOptions& options,
                         SpringState& state);

}  // namespace pleura
