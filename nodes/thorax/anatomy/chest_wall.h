#pragma once

#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/thorax/anatomy/anatomy.h>

namespace pleura {

/// The inner wall of one side of the cage, intercostal spaces included: the distance from a point inside the
/// lung as a smooth function of direction, through the inner lines of the ribs and the backs of the
/// cartilages. Radial basis functions r^3 with a linear part, that is the smoothest such function (Duchon
/// 1977; Carr et al. 2001).
class ChestWall {
 public:
  /// The wall lies `clearance` [m] inside the bones, also where an edge of a rib stands further in than its
  /// inner line.
  ChestWall(const std::vector<Rib>& ribs, const std::vector<Cartilage>& cartilages, Side side,
            double clearance);

  const Eigen::Vector3d& centre() const { return centre_; }
  /// Distance of the wall from the centre in a direction (of unit length) [m].
  double radius(const Eigen::Vector3d& direction) const;
  /// How far a point lies beyond the wall along its ray, negative inside [m].
  double beyond(const Eigen::Vector3d& point) const;

 private:
  void fit(const std::vector<Eigen::Vector3d>& points);

  Eigen::Vector3d centre_;
  std::vector<Eigen::Vector3d> directions_;
  Eigen::VectorXd weights_;  // one a direction, then 1, x, y, z
};

}  // namespace pleura
