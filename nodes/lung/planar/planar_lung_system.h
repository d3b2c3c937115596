#pragma once

#include <span>
#include <vector>

#include <Eigen/Cholesky>

#include <pleura/nodes/lung/planar/condensed_lung.h>
#include <pleura/nodes/lung/planar/hemithorax.h>
#include <pleura/nodes/lung/planar/planar_parameters.h>
#include <pleura/nodes/lung/planar/pleural_space.h>

namespace pleura {

/// What a step did. When it did not converge, or was given what is not finite, the state is that before it.
struct PlanarLungStatus {
  bool isConverged = false;
  int iterations = 0;   // of Newton's method
  double residual = 0;  // [N] the largest force out of balance
};

/// Lungs in a chest of two degrees of freedom, in a coronal section (DeCarlo et al. 1995):
///   M q'' + D q' + K q = f_q,
/// q the lungs' displacements, the diaphragm's and the chest wall's; f_q of intrapleural pressure, contact
/// and breathing muscles. Alveoli are at ambient pressure at all times. Each step is one of backward Euler,
/// solved by Newton's method: stable at any length, one thread, no allocation, the same bits from the same
/// state. Lungs meet in the chest's two equations alone.
class PlanarLungSystem {
 public:
  /// Lungs at their natural shape with air at ambient pressure around them, all at rest. Throws
  /// std::invalid_argument when a parameter is outside the range its comment says.
  explicit PlanarLungSystem(const PlanarLungParameters& parameters);

  /// Sets a pleural space to a gauge pressure [Pa] and holds it there until sealed: 0 is a pneumothorax, an
  /// open wound. Returns false, nothing changed, when it is not finite or below -ambient.
  bool setPressure(std::size_t lung, double gauge);

  /// Closes a pleural space: from now on P V is what it is now.
  void seal(std::size_t lung);

  /// Sets every space to the parameters' pressure, lets the lungs be drawn out to equilibrium, and seals: the
  /// start of the breath. Not converged: all is as before.
  PlanarLungStatus drawOut();

  /// Advances by `seconds`, in [1e-9, 1e9], under the muscles' forces [N] on diaphragm (down) and chest wall
  /// (out).
  PlanarLungStatus step(double seconds, const Eigen::Vector2d& muscles);

  /// Goes to equilibrium under the muscles' forces, at rest.
  PlanarLungStatus settle(const Eigen::Vector2d& muscles);

  std::size_t lungCount() const { return sides_.size(); }
  const planar::Hemithorax& hemithorax(std::size_t lung) const { return sides_[lung].shape; }
  const Eigen::Vector2d& chest() const { return q_; }                 // [m] diaphragm down, wall out
  const Eigen::Vector2d& chestVelocity() const { return velocity_; }  // [m/s]
  double pressure(std::size_t lung) const;                            // [Pa] gauge, of the pleural space
  double pleuralVolume(std::size_t lung) const { return sides_[lung].space.volume(); }  // [m^3]
  double lungArea(std::size_t lung) const { return sides_[lung].space.lungArea(); }     // [m^2]
  bool isSealed(std::size_t lung) const { return sides_[lung].gas.isSealed; }
  Eigen::Vector2d meanAndLargestGap(std::size_t lung) const;  // [m] from lung to wall
  double energy() const;                                      // [J] kinetic, elastic, of gas and of contact

  /// All points of a lung's mesh [m], as many as hemithorax(lung).lung.points. Does not allocate.
  void placeLung(std::size_t lung, std::span<Eigen::Vector2d> points) const;
  std::span<const Eigen::Vector2d> wallPoints(std::size_t lung) const;  // [m]

 private:
  struct Side {
    Side(const planar::SideParameters& lung, const PlanarLungParameters& parameters);

    planar::Hemithorax shape;
    planar::CondensedLung tissue;
    planar::PleuralSpace space;
    planar::PleuralGas gas, gasBefore;
    double relaxationTime;
    Eigen::VectorXd u, velocity;  // of the outline's free points

    // Of a step: the increment, Newton's direction, and where a trial puts it.
    Eigen::VectorXd increment, direction, trial, placed, force;
    Eigen::MatrixXd tangent;
    Eigen::MatrixX2d toChest, solved;
    Eigen::LLT<Eigen::MatrixXd> factor;
  };

  PlanarLungStatus solve(double rate, const Eigen::Vector2d& muscles);
  bool evaluate(double rate, const Eigen::Vector2d& muscles, double part);
  bool factorise(double rate);
  void direct();
  bool startFrom(double rate, const Eigen::Vector2d& muscles, double seconds);
  double slope() const;
  double largestForce() const;
  void commit(double rate);
  void restore();

  Eigen::Vector2d mass_, damping_, stiffness_;
  double intrapleuralPressure_;
  std::vector<Side> sides_;
  Eigen::Vector2d q_ = Eigen::Vector2d::Zero(), velocity_ = Eigen::Vector2d::Zero();

  // Of a step, as for a side.
  Eigen::Vector2d increment_, direction_, trial_, force_;
  Eigen::Matrix2d chestFactor_;
  double scale_ = 0;  // [N] of the forces that balance
};

}  // namespace pleura
