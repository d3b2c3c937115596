#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/lung/planar/rounded_wall.h>

namespace pleura::planar {

/// What fills a pleural space: closed off, P V = amount with P the absolute pressure; or at a given pressure.
/// (With the pressure below that of the air, P V = constant would lift it when the space widens.)
struct PleuralGas {
  bool isSealed = false;
  double gauge = 0;         // [Pa] while not sealed
  double amount = 0;        // [J] while sealed
  double ambient = 101325;  // [Pa] absolute

  double gaugeAt(double volume) const { return isSealed ? amount / volume - ambient : gauge; }
  double stiffnessAt(double volume) const { return isSealed ? amount / (volume * volume) : 0; }  // -dP/dV
};

/// The space between a lung's outline and the wall: pressure and contact, all that lung and chest know of
/// each other, as the derivatives of one potential
///   U = gas(V) + sum_c l_c t p film b(gap_c / film),  V = t (A_wall - A_lung),  b(y) = -(1 - y)^2 ln y for y
///   < 1.
/// The pressure on an edge of length l is then P t l, half on each of its nodes, along its normal: -dV/dx P.
/// (The paper writes P / l; that is a slip.) The contact is frictionless; no lung's point passes the wall.
class PleuralSpace {
 public:
  /// `firstFree`, `freeCount`: the points of the lung's outline that move.
  PleuralSpace(const ChestOutline& wall, std::span<const Eigen::Vector2d> lungOutline, Eigen::Index firstFree,
               Eigen::Index freeCount, double thickness, double film, double naturalScale,
               double contactPressure);

  /// Puts lung and chest in place. False when they touch, or no volume is left: then nothing else may be
  /// asked. This and what follows do not allocate.
  bool place(const Eigen::VectorXd& displacement, const Eigen::Vector2d& q);

  double volume() const { return volume_; }      // [m^3]
  double lungArea() const { return lungArea_; }  // [m^2]
  double energy(const PleuralGas& gas) const;    // [J]

  /// Adds -dU/du [N] and -dU/dq [N].
  void addForces(const PleuralGas& gas, Eigen::VectorXd& onLung, Eigen::Vector2d& onChest) const;

  /// Adds the second derivatives of U [N/m].
  void addStiffness(const PleuralGas& gas, Eigen::MatrixXd& lung, Eigen::MatrixX2d& lungChest,
                    Eigen::Matrix2d& chest) const;

  std::span<const Eigen::Vector2d> wallPoints() const { return wall_.points(); }

  /// Mean and largest distance [m] from the lung's outline, its points and the middles of its edges, to the
  /// wall.
  Eigen::Vector2d meanAndLargestGap() const;

 private:
  /// A place on an edge of the lung: (1 - part) x_i + part x_i+1.
  struct Sample {
    std::size_t edge;
    double part;
    double weight;  // [m^2] of pleura it stands for
  };
  struct Contact {
    std::size_t sample;
    WallGap at;
  };
  Eigen::Vector2d positionOf(const Sample& sample) const;
  Eigen::Index slotOf(std::size_t point) const;  // of x in the displacement; -1 when held

  RoundedWall wall_;
  std::vector<Eigen::Vector2d> rest_, lung_;
  Eigen::Index firstFree_, freeCount_;
  double orientation_, thickness_, film_, contactPressure_;
  double wallArea_ = 0;            // A_wall = wallArea_ + wallGradient_ q + q' wallCurvature_ q / 2
  Eigen::Vector2d wallGradient_;   // [m]
  Eigen::Matrix2d wallCurvature_;  // [1]
  std::vector<Sample> samples_;
  std::vector<Contact> contacts_;
  Eigen::Vector2d q_ = Eigen::Vector2d::Zero();
  double volume_ = 0, lungArea_ = 0;
  Eigen::VectorXd volumeGradient_;  // by the free displacements [m^2]
  Eigen::Vector2d volumeByChest_;   // [m^2]
};

}  // namespace pleura::planar
