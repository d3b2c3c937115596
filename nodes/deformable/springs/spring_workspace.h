#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/springs/spring_interior.h>
#include <pleura/nodes/deformable/springs/spring_model.h>

namespace pleura {

/// One spring's share of a tangent: its force changes by lateral d + n axial (n . d) when its ends part by d.
struct SpringTangent {
  Eigen::Vector3d n;
  double axial;    // [N/m], 0 or more
  double lateral;  // [N/m], 0 or more
};

/// The memory of a solve, allocated once; it keeps nothing from one solve to the next. All vectors have one
/// entry a point, but those of springs.
struct SpringWorkspace {
  explicit SpringWorkspace(const SpringModel& model);

  using Vectors = std::vector<Eigen::Vector3d>;

  // what is minimised: springs, an interior, and inertia that pulls each point to where it would go freely
  std::vector<double> stiffness;  // of springs and dampers together [N/m]
  std::vector<double> length;     // at which those are free of force [m]
  std::vector<double> inertia;    // mass / step^2 [N/m]
  Vectors predicted;              // [m]
  VolumeHold hold;
  std::vector<std::uint8_t> isDriven;

  Vectors position;        // [m]
  Vectors gradient;        // of the energy, 0 at driven points [N]
  Vectors volumeGradient;  // of the volume, 0 at driven points [m^2]
  std::vector<SpringTangent> tangent;

  Vectors trial;                 // position on the line searched
  Vectors direction;             // of the line
  std::vector<double> diagonal;  // inertia and shift, added to the tangent [N/m]
  std::vector<Eigen::Matrix3d>
      preconditioner;  // inverses of the tangent's diagonal blocks, 0 at driven points
  Vectors residual, preconditioned, search, product, preconditionedVolume;
};

}  // namespace pleura
