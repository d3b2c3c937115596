#pragma once

#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <pleura/nodes/deformable/chainmail/chainmail_model.h>
#include <pleura/nodes/deformable/chainmail/chainmail_workspace.h>

namespace pleura {

struct ChainmailOptions {
  Eigen::Isometry3d frame =
      Eigen::Isometry3d::Identity();  // from the rest frame to that of targets and positions
  int smoothingSweeps = 0;            // Laplacian sweeps over the displacement, within limits
};

/// What a solve did. No link is violated unless driven points are farther apart than the links between them
/// allow.
struct ChainmailReport {
  int movedPoints = 0;       // pulled away from rest
  int visits = 0;            // of points by the search; equal to movedPoints when it came to none twice
  int violatedLinks = 0;     // beyond their limits by more than rounding
  float worstViolation = 0;  // [m] the farthest beyond, on any axis
};

/// Moves driven points exactly to their targets [m] and every other point by the least, on each axis of the
/// rest frame, that keeps all links within their limits. Neither earlier solves nor the order of `driven`
/// change a bit. Where driven points contradict each other the points between take the middle, and the report
/// says so. Throws std::invalid_argument, positions untouched, on sizes or indices that do not fit, a target
/// not finite or two for one point, a negative number of sweeps, or a frame that is more than a rotation and
/// a shift.
ChainmailReport solveChainmail(const ChainmailModel& model, ChainmailWorkspace& workspace,
                               std::span<const int> driven, std::span<const Eigen::Vector3f> targets,
                               const ChainmailOptions& options, std::span<Eigen::Vector3f> positions);

}  // namespace pleura
