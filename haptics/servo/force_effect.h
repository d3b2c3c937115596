#pragma once

#include <cstdint>
#include <variant>

#include <Eigen/Core>

namespace pleura::haptics {

/// Pulls the tip to a point of the world once it has come near, until it is pulled off.
struct SpringForce {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
  double stiffness = 100;                              // [N/m]
  double damping = 0;                                  // [N s/m]
  double startDistance = 0.01;                         // [m]
  double escapeDistance = 0.01;                        // [m]
};

/// Drag on a ball in a fluid (Stokes): F = -6 pi eta r v, times a factor.
struct ViscousForce {
  double coefficient = 0;  // [N s/m], 6 pi eta r and the factor
};

struct ConstantForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // [N]
};

/// A_k sin(2 pi f_k t + phi_k) along each axis k.
struct PeriodicForce {
  Eigen::Vector3d amplitude = Eigen::Vector3d::Zero();  // [N]
  Eigen::Vector3d frequency = Eigen::Vector3d::Zero();  // [Hz]
  Eigen::Vector3d phase = Eigen::Vector3d::Zero();      // [rad]
};

/// A force that comes of no surface. `id` is the same in every frame.
struct ForceEffect {
  using Kind = std::variant<SpringForce, ViscousForce, ConstantForce, PeriodicForce>;

  std::uint32_t id = 0;
  Kind kind;
};

/// The effect with no more stiffness [N/m] and damping [N s/m] than those.
ForceEffect atMost(ForceEffect effect, double stiffness, double damping);

/// The force [N] on a tip that is there and moves so, in the world, at `time` [s]. `isActive` is the memory
/// of a spring: whether it holds the tip.
Eigen::Vector3d forceOf(const ForceEffect& effect, const Eigen::Vector3d& position,
                        const Eigen::Vector3d& velocity, double time, bool& isActive);

}  // namespace pleura::haptics
