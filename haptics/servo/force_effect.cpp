#include <algorithm>
#include <cmath>
#include <numbers>

#include <pleura/haptics/servo/force_effect.h>

namespace pleura::haptics {

using Eigen::Vector3d;

namespace {

struct Evaluate {
  const Vector3d& x;
  const Vector3d& v;
  double t;
  bool& isActive;

  /// F = k (x0 - x) - b v while it holds the tip.
  Vector3d operator()(const SpringForce& spring) const {
    const Vector3d offset = spring.position - x;
    const double distance = offset.norm();
    isActive = distance < (isActive ? spring.escapeDistance : spring.startDistance);
    return isActive ? Vector3d(spring.stiffness * offset - spring.damping * v) : Vector3d(Vector3d::Zero());
  }

  Vector3d operator()(const ViscousForce& viscous) const { return -viscous.coefficient * v; }

  Vector3d operator()(const ConstantForce& constant) const { return constant.force; }

  Vector3d operator()(const PeriodicForce& wave) const {
    const Eigen::Array3d angle = 2 * std::numbers::pi * wave.frequency.array() * t + wave.phase.array();
    return wave.amplitude.array() * angle.sin();
  }
};

}  // namespace

ForceEffect atMost(ForceEffect effect, double stiffness, double damping) {
  if (auto* spring = std::get_if<SpringForce>(&effect.kind)) {
    spring->stiffness = std::min(spring->stiffness, stiffness);
    spring->damping = std::min(spring->damping, damping);
  } else if (auto* viscous = std::get_if<ViscousForce>(&effect.kind)) {
    viscous->coefficient = std::min(viscous->coefficient, damping);
  }
  return effect;
}

Vector3d forceOf(const ForceEffect& effect, const Vector3d& position, const Vector3d& velocity, double time,
                 bool& isActive) {
  return std::visit(Evaluate{position, velocity, time, isActive}, effect.kind);
}

}  // namespace pleura::haptics
