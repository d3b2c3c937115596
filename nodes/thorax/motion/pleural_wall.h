#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>
#include <pleura/nodes/thorax/motion/skin.h>

namespace pleura {

/// A bone or cartilage that bounds a pleural cavity: its surface and what carries each of its points.
struct WallBody {
  const TriangleMesh* mesh = nullptr;
  std::vector<BodyWeights> weights;  // one a point; without weights the point stays (the spine)
};

/// The long axis of one hemithorax. Azimuth 0 is lateral, it grows towards the front on either side.
struct HemithoraxAxis {
  Eigen::Vector3d origin;   // [m]
  Eigen::Vector3d up;       // unit
  Eigen::Vector3d lateral;  // unit, perpendicular to up
  Eigen::Vector3d front;    // unit, perpendicular to both

  /// Cylinder coordinates of a point: azimuth [rad] in [-pi, pi), radius and height above the origin [m].
  struct Coordinates {
    double azimuth, radius, height;
  };
  Coordinates coordinates(const Eigen::Vector3d& point) const;
  Eigen::Vector3d radial(double azimuth) const;
};

/// The axis through `low` and `high` [m] on the side whose lateral direction is x = `side` (+1 left, -1
/// right).
HemithoraxAxis hemithoraxAxis(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double side);

/// The inner surface of one half of the cage: a grid of kColumns profiles in half-planes about the axis, each
/// with kRows points equally spaced from the cupola down to below the costal margin.
struct PleuralWall {
  static constexpr int kColumns = 72;  // 5 degrees each
  static constexpr int kRows = 64;

  HemithoraxAxis axis;
  std::vector<double> spacing;          // [kColumns], m between rows; 0 where no bone meets the half-plane
  std::vector<Eigen::Vector4f> rest;    // [kColumns * kRows], (x, y, z, 1), m
  std::vector<Eigen::Vector4f> inward;  // (unit normal at rest, 0), into the cavity
  std::vector<BodyWeights> weights;     // what carries each point

  bool open(int column) const { return spacing[static_cast<std::size_t>(column)] == 0.0; }
  static int next(int column) { return (column + 1) % kColumns; }
  static int previous(int column) { return (column + kColumns - 1) % kColumns; }
  static std::size_t index(int column, int row) {
    return static_cast<std::size_t>(column) * kRows + static_cast<std::size_t>(row);
  }
};

/// Builds the wall from the bones at rest. In each half-plane the profile is what a parabola of curvature k
/// rolled along the inside in log-polar coordinates touches: the lower convex hull of (phi, u + k phi^2 / 2).
/// `cupola` [m] is the height above the axis' origin where the profiles close, fixed to the spine. Throws
/// std::invalid_argument when a body's weights are not one a point.
PleuralWall buildPleuralWall(const HemithoraxAxis& axis, std::span<const WallBody> bodies, double cupola);

/// The grid's triangles, facing inwards.
std::vector<Eigen::Vector3i> wallTriangles(const PleuralWall& wall);

/// Where the wall is now: `now` has the shape of wall.rest; the weights refer to `displacements`.
void moveWall(const PleuralWall& wall, std::span<const BodyDisplacement> displacements,
              std::span<Eigen::Vector4f> now);

}  // namespace pleura
