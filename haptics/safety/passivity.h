#pragma once

#include <cassert>

#include <Eigen/Core>

namespace pleura::haptics {

/// The energy [J] that a rendering has taken from the hand. As a force is held over a period, its work in it
/// is exact, whatever the tip did meanwhile:
///   E_n = E_(n-1) - F_(n-1) . (x_n - x_(n-1))
/// Negative: it has given more than it was given, so it is active. Sources: Hannaford and Ryu, IEEE Trans.
/// Robotics and Automation 18(1), 2002; the exact sum, Stramigioli et al., ICRA 2002.
class PassivityObserver {
 public:
  /// Forgets all energy: where nothing is touched, lest a debt be felt as drag in the air.
  void restart() { energy_ = 0, hasStarted_ = false; }

  /// One tick: the tip is at x [m]; the energy up to now.
  double observe(const Eigen::Vector3d& x) {
    if (hasStarted_) energy_ -= held_.dot(x - position_);
    hasStarted_ = true;
    position_ = x;
    return energy_;
  }

  /// The force [N] that the device really got, held until the next tick.
  void hold(const Eigen::Vector3d& force) { held_ = force; }

  double energy() const { return energy_; }

 private:
  double energy_ = 0;
  bool hasStarted_ = false;
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d held_ = Eigen::Vector3d::Zero();
};

/// The force that takes back by damping what a rendering gave too much, within the next period T [s], from
/// the velocity v [m/s] and the energy E [J] observed:
///   F' = F - a v,  a = min(a_max, -E / (T |v|^2)) where E < 0, otherwise 0
/// a_max [N s/m] is what the device renders stably: m / T stops a free tip within a period, twice that drives
/// it. What a_max leaves is taken in later periods. A long press is credit that an oscillation may use up
/// before this acts: it bounds, it does not silence. Source: Hannaford and Ryu 2002, series controller of an
/// impedance.
inline Eigen::Vector3d passivated(const Eigen::Vector3d& F, const Eigen::Vector3d& v, double E, double T,
                                  double maxDamping) {
  assert(T > 0 && maxDamping >= 0);
  const double taken = T * v.squaredNorm();  // [J] per unit of damping
  if (E >= 0 || taken == 0) return F;
  return F - (-E < maxDamping * taken ? -E / taken : maxDamping) * v;
}

}  // namespace pleura::haptics
