#pragma once

#include <span>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <pleura/nodes/deformable/fem/embedding.h>

namespace pleura {

/// A wall that a body must not pass, as each of its points sees it: a place on it [m] and the unit normal
/// there that leads out of the body. The gap of a point x is g = (wall - x) . n [m]: negative, x is through.
/// It may slide freely. Both spans are as long as the points; they change as the wall moves or points slide.
struct ContactWall {
  std::span<const Eigen::Vector3d> places;
  std::span<const Eigen::Vector3d> normals;

  double gap(std::size_t point, const Eigen::Vector3d& x) const {
    return (places[point] - x).dot(normals[point]);
  }
};

/// Adds the penalty's forces [N], f = k g n where g < 0, the slope of the energy k g^2 / 2 at a fixed wall; k
/// is in N/m. Returns how many points are in contact. Nothing is allocated.
int addContactForces(const ContactWall& wall, double stiffness, std::span<const Eigen::Vector3d> points,
                     std::span<Eigen::Vector3d> forces);

/// A point is active (1) where g < 0: one that a constraint g = 0 would hold back from leaving (g > 0) is let
/// go. Returns how many changed; 0 after a solve with these constraints: it is the solution. Nothing is
/// allocated.
int updateActive(const ContactWall& wall, std::span<const Eigen::Vector3d> points, std::span<char> active);

/// The soft constraints of the active points' gaps, n . x = n . wall, over the nodes' coordinates (x, y and z
/// of node a are columns 3 a to 3 a + 2), one row a point, its tangents left free.
struct ContactRows {
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows;
  Eigen::VectorXd values;  // [m]
};
ContactRows contactRows(const ContactWall& wall, const Embedding& embedding, std::span<const char> active);

}  // namespace pleura
