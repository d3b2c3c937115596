#pragma once

#include <pleura/nodes/deformable/springs/spring_workspace.h>

namespace pleura {

/// Solves (T + diag(inertia + shift) + slope c c^T) direction = -gradient over the points that are not
/// driven, T the springs' tangent and c the volume's gradient, by conjugate gradients preconditioned with the
/// diagonal blocks and, by the formula of Sherman and Morrison, the last term. Any number of iterations
/// leaves a direction of descent. Ends when the preconditioned residual has fallen by `tolerance`. Returns
/// the number of iterations.
int solveSpringSystem(const SpringModel& model, SpringWorkspace& workspace, double slope,
                      double relativeShift, double tolerance, int maxIterations);

}  // namespace pleura
